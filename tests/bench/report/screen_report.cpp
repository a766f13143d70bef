// report_screen: time and error of every screen-space estimator on one volume, as JSON, and if asked for as CSV and as
// a table of Markdown.
//
// Held fixed: the volume, the default camera of `isolume render`, the radius (by default that of `render`) and the size
// of the picture. Milliseconds are of a whole frame of --time-size (G-buffer, estimator, filter, composite, read back),
// the median of --runs after one that is not counted; `none` is the head light, without any such pass. Sweeps have rows
// of their own, with the time of the sweep beside that of a frame. RMSE and bias are over the
// pixels that hit: to the estimator's own integral (screen_truth.h) and to ambient occlusion without a limit, both by
// --rays exact samples per pixel, whose noise is part of the RMSE. Light under a coloured sky has rows of its own
// (light_rows.h).
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "raymarch/context.h"
#include "raymarch/renderer.h"
#include "src/cli/parse_value.h"
#include "src/cli/surface_options.h"
#include "src/io/output_file.h"
#include "src/jobs/camera_choice.h"
#include "src/jobs/reference_camera.h"
#include "src/jobs/screen_light.h"
#include "src/jobs/screen_request.h"
#include "src/jobs/surface.h"
#include "sweep/parallel.h"
#include "tests/bench/report/light_rows.h"
#include "tests/bench/report/report_program.h"
#include "tests/bench/report/screen_truth.h"
#include "tests/bench/report/timing.h"

namespace isolume::bench {
namespace {

struct Options {
  SurfaceRequest surface;
  std::string size = "256x256", timeSize, csv, table;
  double radius = 0;  ///< world units; 0: the default of render
  int samples = 12, rays = 256, runs = 5;
  RunOptions run;
};

/// Every estimator with the z-buffer at the number of samples that was asked for; those that read it with the implicit
/// function as well; and the comparisons that the papers make.
std::vector<ScreenRequest> requests(int samples) {
  std::vector<ScreenRequest> all;
  for (const ScreenEstimator each : screenEstimators()) all.push_back({.estimator = each, .samples = samples});
  for (const BentSource each : {BentSource::crytek2d, BentSource::hbao})
    all.push_back({.estimator = ScreenEstimator::klehm11, .samples = samples, .bentFrom = each});
  for (const ScreenEstimator each : screenEstimators())
    if (readsCharacteristic({.estimator = each}))
      all.push_back({.estimator = each, .samples = samples, .surface = Characteristic::implicit});
  constexpr int kFew = 4, kMany = 32, kLines = 5, kPoints = 12;  // [Szirmay10] Fig. 8, 10; [Loos10] Table 1
  for (const bool sampled : {false, true})
    all.push_back({.estimator = ScreenEstimator::szirmayVolumetric, .samples = kFew, .normalisedBySamples = sampled});
  for (const ScreenEstimator each : {ScreenEstimator::szirmayContainment, ScreenEstimator::szirmayVolumetric})
    all.push_back({.estimator = each, .samples = kMany});
  all.push_back({.estimator = ScreenEstimator::loosLine, .samples = kLines});
  all.push_back({.estimator = ScreenEstimator::loosPoint, .samples = kPoints});
  return all;
}

struct Error {
  double rmse = 0, bias = 0;
};

Error errorOf(const std::vector<glm::vec3>& got, const std::vector<double>& want) {
  double squares = 0, sum = 0, count = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (std::isnan(want[i])) continue;
    const double difference = got[i].r - want[i];
    squares += difference * difference;
    sum += difference;
    count += 1;
  }
  return {std::sqrt(squares / count), sum / count};
}

class Judge {
 public:
  Judge(const Options& options, const SweptScene& swept)
      : options_(options),
        swept_(swept),
        size_(parseSize("--size", options.size)),
        timeSize_(options.timeSize.empty() ? size_ : parseSize("--time-size", options.timeSize)),
        corners_(solidCorners(swept.surface)),
        camera_(chooseCamera({}, corners_, static_cast<double>(size_.x) / size_.y)),
        frame_(makeGridFrame(swept.surface.worldFromGrid)),
        tracer_(swept.surface.level.view()),
        context_(makeContext()),
        renderer_(*context_) {
    SceneFields fields = surfaceFields();
    const SweptLighting lighting = sweepForScreen({}, swept);
    for (const SweptLight& each : lighting.fields) fields.lights.push_back({.values = &each.values});
    renderer_.upload(fields);
    // Where the rays of the pixels hit, and nothing more: shadow takes one ray.
    IntegrandSettings shadow;
    shadow.integrand = Integrand::shadow;
    hits_ = traceReference(scene(), pixelRays(camera_, size_, frame_), {{0, 0}, size_}, shadow, {});
    ambient_ = ambientPicture(scene(), hits_, options.rays);
  }

  nlohmann::ordered_json light() {
    return lightRows({.renderer = renderer_,
                      .camera = camera_,
                      .size = size_,
                      .timeSize = timeSize_,
                      .corners = corners_,
                      .scene = scene(),
                      .hits = hits_,
                      .radius = options_.radius,
                      .samples = options_.samples,
                      .rays = options_.rays,
                      .runs = options_.runs});
  }

  nlohmann::ordered_json row(const ScreenRequest& request) {
    ScreenRequest asked = request;
    if (options_.radius > 0) asked.radius = options_.radius;
    const ScreenOcclusion screen = chooseScreen(asked, corners_).value();
    RenderSettings settings{.size = size_, .shading = Shading::local, .screen = screen, .layers = true};
    const Frame drawn = renderer_.render(camera_, settings);
    const ScreenTruth truth = screenTruth(screen);
    const Error own = errorOf(drawn.light, truthOf(truth, screen.radiusWorld));
    const Error ambient = errorOf(drawn.light, ambient_);
    nlohmann::ordered_json row = screenSettings(screen);
    row["milliseconds"] = milliseconds(settings);
    row["integral"] = screenTruthName(truth);
    row["rmse"] = own.rmse;
    row["bias"] = own.bias;
    row["rmse_ambient"] = ambient.rmse;
    row["bias_ambient"] = ambient.bias;
    return row;
  }

  /// Median of a frame's time without layers.
  double milliseconds(RenderSettings settings) { return milliseconds(renderer_, std::move(settings)); }
  double headLight() { return milliseconds({.size = size_, .shading = Shading::local}); }

  /// Openness by ordinates, and eight octants: the time of the sweep, and the picture drawn with it.
  nlohmann::ordered_json sweepRow(const OcclusionRequest& request) {
    const OcclusionSetting occlusion = chooseOcclusion(request);
    const bool octants = byOctants(occlusion.method);
    const GridView<const float> level = swept_.surface.level.view(), distance = swept_.swept.distance.view();
    SurfaceField openness;
    OctantVisibility visibility;
    const double sweep = median(timedRuns(options_.runs, [&] {
      if (octants)
        visibility = sweepVisibility(distance, VisibilityStorage::rgba8);
      else
        openness = sweepOpenness(level, distance, occlusion.ordinates);
    }));
    SceneFields fields = surfaceFields();
    if (octants)
      for (std::size_t i = 0; i < fields.octants.size(); ++i) fields.octants[i] = visibility.packed[i].view();
    else
      fields.lights = {{&openness}};
    Renderer renderer(*context_);
    renderer.upload(fields);
    const RenderSettings settings{.size = size_,
                                  .shading = octants ? Shading::octants : Shading::lights,
                                  .occlusionOffsetVoxels = static_cast<float>(occlusion.offset),
                                  .openPlaneTerms = occlusion.openPlane,
                                  .layers = true};
    const Error error = errorOf(renderer.render(camera_, settings).light, ambient_);
    nlohmann::ordered_json row = occlusionSettings(occlusion);
    row["sweep_milliseconds"] = sweep;
    row["milliseconds"] = milliseconds(renderer, settings);
    row["rmse_ambient"] = error.rmse;
    row["bias_ambient"] = error.bias;
    return row;
  }
  std::string backend() const { return std::string(context_->backend()) + ", " + context_->description(); }

 private:
  SceneFields surfaceFields() const {
    SceneFields fields;
    fields.worldFromGrid = swept_.surface.worldFromGrid;
    fields.level = swept_.surface.level.view();
    return fields;
  }
  static double median(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    constexpr double kPerSecond = 1000;
    return kPerSecond * seconds[seconds.size() / 2];
  }
  double milliseconds(Renderer& renderer, RenderSettings settings) {
    settings.layers = false;
    settings.size = timeSize_;
    return median(timedRuns(options_.runs, [&] { renderer.render(camera_, settings); }));
  }

  ReferenceScene scene() const { return {tracer_, frame_.worldFromAxes}; }

  const std::vector<double>& truthOf(const ScreenTruth& truth, double radius) {
    for (const auto& [known, picture] : truths_)
      if (known == truth) return picture;
    return truths_.emplace_back(truth, truthPicture(scene(), hits_, truth, radius, options_.rays)).second;
  }

  const Options& options_;
  const SweptScene& swept_;
  glm::ivec2 size_, timeSize_;
  std::array<glm::dvec3, 8> corners_;
  Camera camera_;
  GridFrame frame_;
  SurfaceTracer tracer_;
  std::unique_ptr<Context> context_;
  Renderer renderer_;
  std::vector<ReferencePixel> hits_;
  std::vector<double> ambient_;
  std::vector<std::pair<ScreenTruth, std::vector<double>>> truths_;
};

std::string cell(const nlohmann::ordered_json& row, const char* key) {
  const auto found = row.find(key);
  if (found == row.end()) return "";
  if (found->is_number_float()) return fmt::format("{:.4g}", found->get<double>());
  return found->is_string() ? found->get<std::string>() : found->dump();
}

constexpr std::array kColumns{"occlusion", "bent-from",    "ao-samples", "surface", "ao-normalisation", "membership",
                              "integral",  "milliseconds", "rmse",       "bias",    "rmse_ambient",     "bias_ambient"};

std::string textOf(const nlohmann::ordered_json& rows, const char* before, const char* between, const char* after) {
  std::string text;
  for (const auto& row : rows) {
    text += before;
    for (const char* column : kColumns) text += (column == kColumns[0] ? "" : between) + cell(row, column);
    text += after;
  }
  return text;
}

std::string csvOf(const nlohmann::ordered_json& rows) {
  return fmt::format("{}\n", fmt::join(kColumns, ";")) + textOf(rows, "", ";", "\n");
}

std::string tableOf(const nlohmann::ordered_json& rows) {
  std::string rule;
  for (std::size_t i = 0; i < kColumns.size(); ++i) rule += "|---";
  return fmt::format("| {} |\n{}|\n", fmt::join(kColumns, " | "), rule) + textOf(rows, "| ", " | ", " |\n");
}

nlohmann::ordered_json work(const Options& options) {
  limitThreads(options.run.threads);
  StageLog log(options.run);
  const SweptScene scene = loadScene(options.surface, {.distance = true}, log);
  Judge judge(options, scene);
  nlohmann::ordered_json report{{"size", options.size},
                                {"time_size", options.timeSize.empty() ? options.size : options.timeSize},
                                {"threads", threadCount()},
                                {"gl", judge.backend()}};
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  rows.push_back({{"occlusion", "none"}, {"milliseconds", judge.headLight()}});
  for (const ScreenRequest& each : requests(options.samples)) rows.push_back(judge.row(each));
  if (!options.csv.empty()) writeFileAtomically(options.csv, csvOf(rows));
  if (!options.table.empty()) writeFileAtomically(options.table, tableOf(rows));
  report["rows"] = rows;
  report["sweeps"] = nlohmann::ordered_json::array();
  for (const OcclusionRequest& each : {OcclusionRequest{.method = OcclusionMethod::singh10},
                                       {.method = OcclusionMethod::octants},
                                       {.method = OcclusionMethod::octants, .openPlane = true},
                                       {.ordinates = 64, .refinement = 1},
                                       {.ordinates = 128, .refinement = 1},
                                       {.ordinates = 512, .refinement = 1},
                                       {.ordinates = 1024, .refinement = 2}})
    report["sweeps"].push_back(judge.sweepRow(each));
  report["light"] = judge.light();
  return report;
}

}  // namespace
}  // namespace isolume::bench

int main(int argc, char** argv) {
  using namespace isolume;
  bench::Options options;
  CLI::App app{"Times and judges the screen-space estimators on one volume.", "report_screen"};
  addSurfaceOptions(app, options.surface);
  addRunOptions(app, options.run);
  app.add_option("--size", options.size, "WxH, pixels");
  app.add_option("--time-size", options.timeSize, "WxH, pixels of the frames that are timed (default: --size)");
  app.add_option("--radius", options.radius, "world units")->check(CLI::PositiveNumber);
  app.add_option("--samples", options.samples, "per pixel")->check(CLI::Range(1, kMostScreenSamples));
  app.add_option("--rays", options.rays, "exact samples per pixel")->check(CLI::PositiveNumber);
  app.add_option("--runs", options.runs, "timed frames")->check(CLI::PositiveNumber);
  app.add_option("--csv", options.csv, "file to write");
  app.add_option("--table", options.table, "file to write");
  return bench::runReportProgram(app, argc, argv, [&options] { return bench::work(options); });
}
