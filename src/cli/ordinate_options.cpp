#include "src/cli/ordinate_options.h"

#include "src/cli/option_builder.h"
#include "src/cli/parse_value.h"

namespace isolume {

void addOrdinatesOption(CLI::App& app, const std::string& group, OcclusionRequest& request,
                        const std::string& meaning) {
  OptionGroup(app, group)
      .value(
          "--ordinates", "N",
          [&request](const std::string& option, const std::string& text) {
            request.ordinates = parseCount(option, text, kLeastOrdinates, kMostOrdinates);
          },
          fmt::format("{}, {} to {}", meaning, kLeastOrdinates, kMostOrdinates));
}

void addTransportOptions(CLI::App& app, const std::string& group, OcclusionRequest& request) {
  OptionGroup options(app, group);
  Choices<OcclusionTransport> transports;
  for (const auto each : {OcclusionTransport::rays, OcclusionTransport::step, OcclusionTransport::characteristic})
    transports.emplace_back(transportName(each), each);
  options.value(
      "--transport", "SCHEME",
      [&request, transports](const std::string& option, const std::string& text) {
        request.transport = parseChoice(option, text, transports);
      },
      fmt::format("how ordinates pass the grid: rays of one bit; step or\ncharacteristic: light from voxel to voxel, "
                  "smoother with few\n(default: rays; the others with {} ordinates)",
                  TransportOptions().ordinates));
  Choices<Transmittance> transmittances;
  for (const auto each : {Transmittance::centred, Transmittance::inside, Transmittance::insideByLength})
    transmittances.emplace_back(transmittanceName(each), each);
  options.value(
      "--transmittance", "RAMP",
      [&request, transmittances](const std::string& option, const std::string& text) {
        request.transmittance = parseChoice(option, text, transmittances);
      },
      "of a voxel, by its distance over the smallest spacing:\ncentred from -1/2 to 1/2; inner from -1 to 0; "
      "inner-power\nby the length of the way through it (default: inner with\nstep, centred with characteristic)");
}

}  // namespace isolume
