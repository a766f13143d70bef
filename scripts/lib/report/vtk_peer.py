"""VTK on one scene, timed: vtk_peer.py LEVELS.raw SCENE.json PREFIX RUNS KERNELS. Prints JSON.

First picture: from the samples in memory to pixels in memory, with a new window. Further picture: the camera is moved
by a thousandth of a degree, so that nothing is reused. Everything runs once to warm up, then RUNS times.
"""

import json
import sys
import time
from pathlib import Path
from typing import Any, Callable

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from exr import write_exr

NUDGE_DEGREES = 0.001
SSAO_RADIUS = 0.1  # of the scene's diagonal, and
SSAO_BIAS = 0.001  # the same: the values of VTK's own example
Place = dict[str, Any]


def image_of(levels: Path, place: Place) -> vtk.vtkImageData:
    """The samples, > 0 inside; shared with numpy, not copied."""
    values = np.fromfile(levels, dtype="<f4")
    array = numpy_to_vtk(values, deep=0)
    image = vtk.vtkImageData()
    image.SetDimensions(place["dims"])
    image.SetSpacing(place["spacing"])
    image.SetOrigin(place["origin"])
    image.GetPointData().SetScalars(array)
    image.values = values  # keeps the samples alive
    return image


def window_of(place: Place, prop: vtk.vtkProp3D) -> tuple[vtk.vtkRenderWindow, vtk.vtkRenderer]:
    """A window off the screen that looks at the scene as `isolume render` does."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0, 0, 0)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(place["eye"])
    camera.SetFocalPoint(place["target"])
    camera.SetViewUp(place["up"])
    camera.SetViewAngle(place["fov"])
    renderer.AddViewProp(prop)
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(place["size"])
    window.AddRenderer(renderer)
    return window, renderer


def pixels(window: vtk.vtkRenderWindow) -> np.ndarray:
    """Draws, and reads back: rows from the top, 8-bit RGB."""
    window.Render()
    width, height = window.GetSize()
    data = vtk.vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, data, 0)
    return vtk_to_numpy(data).reshape(height, width, 3)[::-1]


def volume_prop(image: vtk.vtkImageData) -> vtk.vtkVolume:
    mapper = vtk.vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.SetBlendModeToIsoSurface()
    mapper.SetAutoAdjustSampleDistances(0)
    mapper.SetSampleDistance(min(image.GetSpacing()))
    color, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    color.AddRGBPoint(0, 1, 1, 1)
    opacity.AddPoint(0, 1)
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    looks = volume.GetProperty()
    looks.SetColor(color)
    looks.SetScalarOpacity(opacity)
    looks.SetInterpolationTypeToLinear()
    looks.ShadeOn()
    looks.GetIsoSurfaceValues().SetValue(0, 0)
    return volume


def mesh_prop(image: vtk.vtkImageData) -> vtk.vtkActor:
    edges = vtk.vtkFlyingEdges3D()
    edges.SetInputData(image)
    edges.SetValue(0, 0)
    edges.ComputeNormalsOn()
    edges.ComputeScalarsOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(edges.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    # White without any shading. Lighting stays on: without it the mapper has no normals, and the pass does nothing.
    looks = actor.GetProperty()
    looks.SetColor(1, 1, 1)
    looks.SetAmbient(1)
    looks.SetDiffuse(0)
    looks.SetSpecular(0)
    return actor


def add_ssao(renderer: vtk.vtkRenderer, kernel: int) -> None:
    diagonal = np.linalg.norm(np.diff(np.reshape(renderer.ComputeVisiblePropBounds(), (3, 2)), axis=1))
    ssao = vtk.vtkSSAOPass()
    ssao.SetRadius(SSAO_RADIUS * diagonal)
    ssao.SetBias(SSAO_BIAS * diagonal)
    ssao.SetKernelSize(kernel)
    ssao.BlurOn()
    ssao.SetDelegatePass(vtk.vtkRenderStepsPass())
    renderer.SetPass(ssao)


def measure(place: Place, make: Callable[[], vtk.vtkProp3D], kernel: int | None, runs: int) -> dict[str, Any]:
    """Times of the first and a further picture, and the first picture itself."""
    first, further, picture = [], [], None
    for _ in range(runs + 1):
        start = time.perf_counter()
        window, renderer = window_of(place, make())
        if kernel:
            add_ssao(renderer, kernel)
        picture = pixels(window)
        first.append(time.perf_counter() - start)
        renderer.GetActiveCamera().Azimuth(NUDGE_DEGREES)
        start = time.perf_counter()
        pixels(window)
        further.append(time.perf_counter() - start)
        window.Finalize()
    return {"first": first[1:], "further": further[1:], "image": picture}


def write_openness(path: Path, shaded: np.ndarray, plain: np.ndarray) -> None:
    """The unlit white surface with the pass over the one without; Z tells what was hit."""
    hit = plain[:, :, 0] > 0
    openness = np.where(hit, shaded[:, :, 0] / np.maximum(plain[:, :, 0], 1), 1)
    write_exr(path, {"ambient.Y": openness, "Z": np.where(hit, 0, np.inf)})


def main(levels: Path, scene: Path, prefix: str, runs: int, kernels: list[int]) -> None:
    place = json.loads(scene.read_text(encoding="utf-8"))
    image = image_of(levels, place)
    results = []
    volume = measure(place, lambda: volume_prop(image), None, runs)
    plain = measure(place, lambda: mesh_prop(image), None, runs)
    for method, result in (("VTK volume mapper, no occlusion", volume), ("VTK mesh, no occlusion", plain)):
        results.append({"method": method, "first": result["first"], "further": result["further"]})
    for kernel in kernels:
        shaded = measure(place, lambda: mesh_prop(image), kernel, runs)
        picture = Path(f"{prefix}{kernel}.exr")
        write_openness(picture, shaded["image"], plain["image"])
        results.append({"method": "VTK mesh with SSAO", "knob": kernel, "first": shaded["first"],
                        "further": shaded["further"], "picture": str(picture)})
    if not volume["image"].any():
        sys.exit("vtk_peer.py: the volume mapper drew nothing")
    print(json.dumps({"version": vtk.vtkVersion().GetVTKVersion(), "pictures": results}))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3], int(sys.argv[4]), [int(k) for k in sys.argv[5].split(",")])
