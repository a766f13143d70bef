"""What is measured: scenes, sizes, threads, runs, and the quality knobs of every method."""

import os
from dataclasses import dataclass


@dataclass(frozen=True)
class Volume:
    """A volume file that a machine may have, with the surface that is shown of it."""

    name: str
    file: str
    surface: tuple[str, ...]


# Cubic voxels and a solid that stays off the border: what every distance solver can work on.
BETA_GALACTOSIDASE = Volume("beta-galactosidase", "betaGal.mrc", ("--isovalue", "0.06", "--inside", "above"))
# A head by computed tomography, cut by the border, with voxels that are not cubes.
CRANIUM = Volume("cranium", "cranium.mhd", ("--isovalue", "300", "--inside", "above"))


@dataclass(frozen=True)
class Matrix:
    """One report."""

    name: str
    runs: int
    threads: tuple[int, ...]
    distance_threads: tuple[int, ...]
    distance_shapes: tuple[str, ...]
    distance_sizes: tuple[int, ...]
    distance_volumes: tuple[Volume, ...]
    judged: int  # voxels with a true distance: from anywhere, and as many near the surface
    occlusion_scenes: tuple[str, ...]
    occlusion_sizes: tuple[int, ...]
    occlusion_volumes: tuple[Volume, ...]
    picture: tuple[int, int]
    reference_rays: int
    offsets: tuple[float, ...]  # --occlusion-offset, voxels
    ordinates: tuple[tuple[int, int], ...]  # --ordinates and --refinement
    calibration: tuple[int, int, int]  # samples along each axis, points of each surface, rays of the truth at each
    rays: tuple[int, ...]  # Embree, per pixel
    kernels: tuple[int, ...]  # VTK's SSAO, samples per pixel
    large_scenes: tuple[str, ...]  # of the occlusion scenes, by the start of their names: drawn again, larger
    large_picture: tuple[int, int]
    large_reference_rays: int
    large_ordinates: tuple[tuple[int, int], ...]
    large_rays: tuple[int, ...]
    screen_scene: str
    screen_size: int
    screen_volumes: tuple[Volume, ...]
    screen_picture: tuple[int, int]  # that is judged
    screen_time: tuple[int, int]  # that is timed
    screen_samples: int
    screen_rays: int
    scaling_scene: str
    scaling_sizes: tuple[int, ...]
    table_repetitions: int
    table_sizes: tuple[tuple[int, int, int], ...]


def thread_counts() -> tuple[int, ...]:
    """One, and all cores that this process may use."""
    cores = len(os.sched_getaffinity(0))
    return (1, cores) if cores > 1 else (1,)


PAPER_SIZES = ((101, 101, 61), (100, 100, 100), (150, 150, 150), (200, 200, 200), (250, 250, 250))

FULL = Matrix(
    name="full",
    runs=3,
    threads=thread_counts(),
    distance_threads=thread_counts()[-1:],  # OpenVDB takes a minute and more on one
    distance_shapes=("sphere", "torus", "gyroid"),
    distance_sizes=(250,),
    distance_volumes=(BETA_GALACTOSIDASE,),
    judged=2000,
    occlusion_scenes=("corner", "gyroid"),
    occlusion_sizes=(256,),
    occlusion_volumes=(BETA_GALACTOSIDASE, CRANIUM),
    picture=(512, 512),
    reference_rays=1024,
    offsets=(0, 2),
    ordinates=((64, 1), (128, 1), (256, 1), (512, 1), (1024, 2), (4096, 2)),
    calibration=(128, 2000, 4096),
    rays=(16, 64, 256, 1024),
    kernels=(32, 128),
    large_scenes=("gyroid", BETA_GALACTOSIDASE.name, CRANIUM.name),
    large_picture=(1024, 1024),
    large_reference_rays=256,
    large_ordinates=((64, 1), (512, 1)),
    large_rays=(256, 1024),
    screen_scene="corner",
    screen_size=128,
    screen_volumes=(BETA_GALACTOSIDASE,),
    screen_picture=(256, 256),
    screen_time=(1024, 1024),
    screen_samples=12,
    screen_rays=128,
    scaling_scene="capsules",
    scaling_sizes=(64, 128, 256, 512),
    table_repetitions=15,
    table_sizes=PAPER_SIZES,
)

QUICK = Matrix(
    name="quick",
    runs=1,
    threads=thread_counts()[-1:],
    distance_threads=FULL.distance_threads,
    distance_shapes=FULL.distance_shapes,
    distance_sizes=(64,),
    distance_volumes=FULL.distance_volumes,
    judged=500,
    occlusion_scenes=("corner", "gyroid", "capsules"),
    occlusion_sizes=(64,),
    occlusion_volumes=(BETA_GALACTOSIDASE,),
    picture=(256, 256),
    reference_rays=64,
    offsets=FULL.offsets,
    ordinates=((64, 1), (512, 1), (1024, 2)),
    calibration=(48, 200, 256),
    rays=(4, 16, 64),
    kernels=(32,),
    large_scenes=("gyroid",),
    large_picture=(320, 320),
    large_reference_rays=16,
    large_ordinates=((64, 1),),
    large_rays=(16,),
    screen_scene=FULL.screen_scene,
    screen_size=48,
    screen_volumes=(),
    screen_picture=(48, 48),
    screen_time=(64, 64),
    screen_samples=FULL.screen_samples,
    screen_rays=16,
    scaling_scene=FULL.scaling_scene,
    scaling_sizes=(64, 128),
    table_repetitions=1,
    table_sizes=PAPER_SIZES[:2],
)
