#include "tests/bench/report/light_rows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sweep/parallel.h"
#include "sweep/reference/environment.h"
#include "tests/bench/report/timing.h"

namespace isolume::bench {
namespace {

constexpr glm::ivec2 kMapSize{128, 64};

/// Warm towards one side, blue towards the other: no symmetry with the grid's axes.
std::vector<glm::vec3> twoColours() {
  constexpr glm::vec3 kWarm{0.95F, 0.45F, 0.05F}, kBlue{0.05F, 0.1F, 0.85F};
  constexpr glm::dvec3 kSide{0.8, -0.4, 0.35};
  std::vector<glm::vec3> map;
  for (int y = 0; y < kMapSize.y; ++y)
    for (int x = 0; x < kMapSize.x; ++x) {
      const double fall = std::numbers::pi * (y + 0.5) / kMapSize.y,
                   turn = 2 * std::numbers::pi * ((x + 0.5) / kMapSize.x - 0.5);
      const glm::dvec3 direction(std::sin(fall) * std::sin(turn), std::sin(fall) * std::cos(turn), std::cos(fall));
      map.push_back(glm::dot(direction, kSide) > 0 ? kWarm : kBlue);
    }
  return map;
}

/// Of the pixels that hit.
std::vector<glm::dvec3> exactLight(const LitView& view, const Environment& environment) {
  IntegrandSettings integrand;
  integrand.integrand = Integrand::environment;
  integrand.environment = &environment;
  std::vector<glm::dvec3> light(view.hits.size());
  parallelFor(light.size(), [&](std::size_t i) {
    if (!view.hits[i].hit) return;
    const PointEstimate estimate =
        estimateAt(view.scene, integrand, {.rays = view.rays}, view.hits[i].point, static_cast<std::uint64_t>(i));
    light[i] = {estimate.channels.value[0], estimate.channels.value[1], estimate.channels.value[2]};
  });
  return light;
}

struct Variant {
  ScreenRequest request;
  bool lit = true;
};

/// The plain occlusion first.
std::vector<std::vector<Variant>> variants(int samples) {
  std::vector<std::vector<Variant>> all;
  for (const BentSource source : {BentSource::crytek2d, BentSource::crytek3d, BentSource::hbao, BentSource::sweep}) {
    ScreenRequest request{.estimator = ScreenEstimator::klehm11, .bentFrom = source};
    if (source != BentSource::sweep) request.samples = samples;
    request.bent = BentLight::none;
    std::vector<Variant> group{{request, false}};
    for (const BentLight light : {BentLight::none, BentLight::normal, BentLight::cone, BentLight::cap}) {
      request.bent = light;
      group.push_back({request});
    }
    all.push_back(group);
  }
  for (const ScreenEstimator each : {ScreenEstimator::ssdo, ScreenEstimator::envImportance}) {
    const ScreenRequest request{.estimator = each, .samples = samples};
    all.push_back({{request, false}, {request, true}});
  }
  return all;
}

void addErrors(nlohmann::ordered_json& row, const LitView& view, const Frame& frame,
               const std::vector<glm::dvec3>& want) {
  double squares = 0, sum = 0, count = 0;
  for (std::size_t i = 0; i < want.size(); ++i) {
    if (!view.hits[i].hit) continue;
    const glm::dvec3 difference = glm::dvec3(frame.light[i]) - want[i];
    squares += glm::dot(difference, difference);
    sum += difference.r + difference.g + difference.b;
    count += 3;
  }
  row["rmse"] = std::sqrt(squares / count);
  row["bias"] = sum / count;
}

}  // namespace

nlohmann::ordered_json lightRows(const LitView& view) {
  const Environment environment(kMapSize, twoColours());
  const std::vector<glm::dvec3> want = exactLight(view, environment);
  auto sky = std::make_shared<SkyCube>();
  addMappedSky(*sky, kMapSize, twoColours(), 0, 1, view.scene.worldFromAxes);
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const std::vector<Variant>& group : variants(view.samples)) {
    std::vector<RenderSettings> settings;
    for (const Variant& each : group) {
      ScreenRequest request = each.request;
      if (view.radius > 0) request.radius = view.radius;
      ScreenOcclusion screen = chooseScreen(request, view.corners).value();
      if (each.lit) screen.sky = sky;
      settings.push_back({.size = view.size, .shading = Shading::local, .screen = screen, .layers = true});
    }
    std::vector<Frame> frames;
    for (RenderSettings& each : settings) {
      frames.push_back(view.renderer.render(view.camera, each));
      each.layers = false;
      each.size = view.timeSize;
      view.renderer.render(view.camera, each);
    }
    std::vector<std::vector<double>> seconds(settings.size());
    for (int run = 0; run < view.runs; ++run)
      for (std::size_t i = 0; i < settings.size(); ++i)
        seconds[i].push_back(secondsOf([&] { view.renderer.render(view.camera, settings[i]); }));
    for (std::vector<double>& each : seconds) std::nth_element(each.begin(), each.begin() + view.runs / 2, each.end());
    const auto middle = static_cast<std::size_t>(view.runs / 2);
    for (std::size_t i = 0; i < settings.size(); ++i) {
      nlohmann::ordered_json row = screenSettings(settings[i].screen.value());
      row["sky"] = group[i].lit ? "two colours" : "even";
      constexpr double kPerSecond = 1000;
      row["milliseconds"] = kPerSecond * seconds[i][middle];
      row["over_occlusion"] = seconds[i][middle] / seconds[0][middle] - 1;
      if (group[i].lit) addErrors(row, view, frames[i], want);
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace isolume::bench
