#include "vascular_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gradient_noise.h"
#include "random.h"

namespace isolume {
namespace {

struct Node {
  glm::dvec3 position;
  int parent;  // -1: the root; always less than the node's own index
};

struct Attractor {
  glm::dvec3 position;
  int nearest = 0;
  double distance = 0;  // to that node
};

constexpr std::uint64_t kSeed = 17;
constexpr double kStep = 0.016;         // length of a piece of vessel
constexpr double kSupplied = 0.034;     // an attractor this near to a vessel is done
constexpr double kInfluence = 0.12;     // vessels do not feel attractors farther away
constexpr int kAttractorsPerAxis = 14;  // sets the density: one attractor in each cell of that grid
constexpr double kMargin = 0.03;        // tissue ends short of the border of the cube

std::vector<Attractor> scatterAttractors(Random& random) {
  std::vector<Attractor> attractors;
  const double cell = (1 - 2 * kMargin) / kAttractorsPerAxis;
  for (int z = 0; z < kAttractorsPerAxis; ++z)
    for (int y = 0; y < kAttractorsPerAxis; ++y)
      for (int x = 0; x < kAttractorsPerAxis; ++x)
        attractors.push_back({glm::dvec3(kMargin) + cell * (glm::dvec3(x, y, z) + random.inBox(0, 1))});
  return attractors;
}

void noticeNode(std::vector<Attractor>& attractors, const std::vector<Node>& nodes, int index) {
  for (Attractor& attractor : attractors) {
    const double distance = glm::length(attractor.position - nodes[index].position);
    if (index == 0 || distance < attractor.distance) {
      attractor.nearest = index;
      attractor.distance = distance;
    }
  }
}

// One round: every node that is somebody's nearest grows one step. Returns the number of new nodes.
int growOnce(std::vector<Node>& nodes, std::vector<Attractor>& attractors, Random& random) {
  std::vector<glm::dvec3> pull(nodes.size(), glm::dvec3(0));
  for (const Attractor& attractor : attractors)
    if (attractor.distance < kInfluence)
      pull[attractor.nearest] += (attractor.position - nodes[attractor.nearest].position) / attractor.distance;
  const int before = static_cast<int>(nodes.size());
  for (int i = 0; i < before; ++i) {
    if (pull[i] == glm::dvec3(0)) continue;
    // Vessels keep some of their direction and wander a little; the wandering also parts attractors in balance.
    constexpr double kMomentum = 0.9, kWander = 0.9;
    const glm::dvec3 from = nodes[i].parent < 0 ? glm::dvec3(0) : nodes[i].position - nodes[nodes[i].parent].position;
    const glm::dvec3 direction = glm::normalize(pull[i]) + kMomentum * from / kStep + kWander * random.direction();
    nodes.push_back({nodes[i].position + kStep * glm::normalize(direction), i});
    noticeNode(attractors, nodes, static_cast<int>(nodes.size()) - 1);
  }
  std::erase_if(attractors, [](const Attractor& a) { return a.distance < kSupplied; });
  return static_cast<int>(nodes.size()) - before;
}

// The vessel that the tissue is supplied from: a cubic curve from one side of the cube to the opposite one.
std::vector<Node> artery() {
  const std::array<glm::dvec3, 4> control{glm::dvec3(0, 0.25, 0.3), glm::dvec3(0.55, 0.05, 1.0),
                                          glm::dvec3(0.45, 0.95, 0.0), glm::dvec3(1, 0.75, 0.7)};
  constexpr int kPieces = 90;  // of about kStep
  std::vector<Node> nodes;
  for (int i = 0; i <= kPieces; ++i) {
    const double t = static_cast<double>(i) / kPieces, s = 1 - t;
    const glm::dvec3 p =
        s * s * s * control[0] + 3 * s * s * t * control[1] + 3 * s * t * t * control[2] + t * t * t * control[3];
    nodes.push_back({p, i - 1});
  }
  return nodes;
}

std::vector<Node> growNodes() {
  Random random(kSeed);
  std::vector<Attractor> attractors = scatterAttractors(random);
  std::vector<Node> nodes = artery();
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) noticeNode(attractors, nodes, i);
  constexpr int kRounds = 400;  // a vessel that circles an attractor without ever supplying it ends here
  for (int round = 0; round < kRounds && !attractors.empty(); ++round)
    if (growOnce(nodes, attractors, random) == 0) break;
  return nodes;
}

// Rounds the corners between pieces, then bends everything along with a smooth displacement: vessels wind.
void smoothAndWind(std::vector<Node>& nodes) {
  constexpr int kPasses = 3;
  for (int pass = 0; pass < kPasses; ++pass) {
    std::vector<glm::dvec3> sum(nodes.size(), glm::dvec3(0));
    std::vector<int> children(nodes.size(), 0);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      sum[nodes[i].parent] += nodes[i].position;
      ++children[nodes[i].parent];
    }
    std::vector<Node> moved = nodes;
    for (std::size_t i = 1; i < nodes.size(); ++i)
      if (children[i] > 0)
        moved[i].position =
            (nodes[i].position + 0.5 * (nodes[nodes[i].parent].position + sum[i] / static_cast<double>(children[i]))) /
            2.0;
    nodes = moved;
  }
  constexpr double kFrequency = 8, kAmplitude = 0.02;
  for (Node& node : nodes) {
    const glm::dvec3 q = kFrequency * node.position;
    node.position += kAmplitude * glm::dvec3(gradientNoiseValue(q, kSeed + 1), gradientNoiseValue(q, kSeed + 2),
                                             gradientNoiseValue(q, kSeed + 3));
  }
}

std::vector<double> radii(const std::vector<Node>& nodes) {
  constexpr double kCapillary = 0.006, kArtery = 0.018;
  std::vector<double> cubes(nodes.size(), 0.0);
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (cubes[i] == 0) cubes[i] = kCapillary * kCapillary * kCapillary;  // an end
    if (nodes[i].parent >= 0) cubes[nodes[i].parent] += cubes[i];        // [Murray26]
  }
  std::vector<double> result;
  for (const double cube : cubes) result.push_back(std::min(std::cbrt(cube), kArtery));
  // A branch narrows over a few pieces, not at once.
  constexpr int kPasses = 4;
  constexpr double kShareOfParent = 0.25;
  for (int pass = 0; pass < kPasses; ++pass)
    for (std::size_t i = nodes.size(); i-- > 1;) result[i] += kShareOfParent * (result[nodes[i].parent] - result[i]);
  return result;
}

}  // namespace

std::vector<TaperedCapsule> growVascularTree() {
  std::vector<Node> nodes = growNodes();
  smoothAndWind(nodes);
  const std::vector<double> radius = radii(nodes);
  std::vector<TaperedCapsule> pieces;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const int parent = nodes[i].parent;
    pieces.push_back({nodes[parent].position, nodes[i].position, radius[parent], radius[i]});
  }
  return pieces;
}

}  // namespace isolume
