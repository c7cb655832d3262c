// Thesis chapter 5: how far each of its choices is from the continuous scene.
#include "sw/chapter5/choices.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>

#include "sim/bounce.h"
#include "sim/job.h"
#include "sim/lights.h"
#include "sim/render_job.h"
#include "sim/table_command.h"
#include "sim/true_picture.h"
#include "sw/chapter5/tracer.h"
#include "sw/facet/optics.h"
#include "sw/picture/compose.h"
#include "sw/picture/difference.h"

namespace rc2 {
namespace {

using chapter5::Choices;
using chapter5::NamedChoices;
using chapter5::Owner;
using chapter5::Voxels;

constexpr int kDepths[] = {1, 4};

struct Row {
  std::string scene;
  int n;
  std::string choice;
  Bounce bounce;
  std::vector<picture::Difference> pictures;  // by kDepths; lamps shine everywhere
};

class Bench {
 public:
  Bench(const std::string& name, int n)
      : n_(n), job_(prepare(options(name, n), true)), truth_(job_.scene, bodies_of(job_), n) {
    name_ = std::filesystem::path(name).filename().string();
    optics_ = facet::find_optics(job_.facets.facets, job_.scene.materials);
    for (const Owner owner : {Owner::core, Owner::nearest, Owner::first})
      voxels_.emplace(owner, Voxels(job_.facets.packets, optics_, n, owner));
    lamps_ = choose_lamps({}, job_.scene, n);
    place_lamps(lamps_, voxels_.at(Owner::core).memory(), n);
    sights_ = front_sights(n);
    for (const int depth : kDepths)
      expected_.push_back(true_picture(truth_, sights_, lamps_.list, depth, false));
  }

  Row measure(const NamedChoices& named) const {
    const Choices& choices = named.choices;
    const Voxels& voxels = voxels_.at(choices.owner);
    const auto from_surface = [&](const RayJob& job) {
      return chapter5::trace(voxels, job, choices, false);
    };
    Row row{
        name_, n_, named.name, measure_bounce(truth_, job_.scene, optics_, from_surface, n_), {}};
    const RayResult seen =
        chapter5::trace(voxels, {{4, weight_of(kDefaultLeastWeight)}, &optics_}, choices, true);
    const std::vector<picture::Lamp> lit =
        lit_lamps(lamps_.list, std::vector<LightMemory>(lamps_.list.size()));
    const picture::Traced traced{n_, voxels.memory(), job_.facets.facets, job_.scene.materials,
                                 seen.hits};
    for (std::size_t i = 0; i < expected_.size(); ++i)
      row.pictures.push_back(
          picture::difference(picture::compose(traced, lit, kDepths[i]), expected_[i]));
    return row;
  }

 private:
  static SceneOptions options(const std::string& name, int n) {
    SceneOptions options;
    options.scene = name;
    options.n = n;
    options.fraction_bits = kRenderFraction;
    return options;
  }

  int n_;
  std::string name_;
  Job job_;
  truth::Whitted truth_;
  std::vector<rays::Facet> optics_;
  std::map<Owner, Voxels> voxels_;
  Lamps lamps_;
  std::vector<Sight> sights_;
  std::vector<picture::Image> expected_;
};

// What a row says, as text and in the file.
struct Numbers {
  explicit Numbers(const Row& row) {
    const Bounce& bounce = row.bounce;
    const auto rays = static_cast<double>(bounce.rays);
    const double good = rays - static_cast<double>(bounce.gross);
    gross = rays > 0 ? 100 * static_cast<double>(bounce.gross) / rays : 0;
    early = rays > 0 ? 100 * static_cast<double>(bounce.early) / rays : 0;
    straight = rays > 0 ? 100 * static_cast<double>(bounce.straight) / rays : 0;
    distance = good > 0 ? bounce.distance / good : 0;
    degrees = good > 0 ? bounce.degrees / good : 0;
  }
  double gross, early, straight, distance, degrees;
};

void print(const std::vector<Row>& rows) {
  fmt::print("{:<12}{:>5}  {:<32}{:>9}{:>9}{:>9}{:>9}{:>9}{:>10}{:>10}{:>9}{:>9}\n", "scene", "n",
             "choice", "> 2 vx %", "early %", "mean vx", "degrees", "1 deg %", "wrong, 1",
             "wrong, 4", "RMSE, 1", "RMSE, 4");
  for (const Row& row : rows) {
    const Numbers of(row);
    fmt::print(
        "{:<12}{:>5}  {:<32}{:>9.2f}{:>9.2f}{:>9.3f}{:>9.2f}{:>9.1f}{:>10.2f}{:>10.2f}"
        "{:>9.4f}{:>9.4f}\n",
        row.scene, row.n, row.choice, of.gross, of.early, of.distance, of.degrees, of.straight,
        100 * row.pictures[0].wrong, 100 * row.pictures[1].wrong, row.pictures[0].rmse,
        row.pictures[1].rmse);
  }
}

std::string to_csv(const std::vector<Row>& rows) {
  std::string csv =
      "scene,n,choice,gross_percent,early_percent,mean_distance,mean_degrees,straight_percent,"
      "wrong_percent_1,wrong_percent_4,rmse_1,rmse_4\n";
  for (const Row& row : rows) {
    const Numbers of(row);
    csv +=
        fmt::format("{},{},\"{}\",{:.4f},{:.4f},{:.5f},{:.4f},{:.4f},{:.4f},{:.4f},{:.5f},{:.5f}\n",
                    row.scene, row.n, row.choice, of.gross, of.early, of.distance, of.degrees,
                    of.straight, 100 * row.pictures[0].wrong, 100 * row.pictures[1].wrong,
                    row.pictures[0].rmse, row.pictures[1].rmse);
  }
  return csv;
}

}  // namespace

void declare_choices(Command& program) {
  auto options = std::make_shared<TableOptions>();
  options->sides = {32, 64};
  Command command = program.command(
      "choices", "Compares chapter 5's choices of normal, hit and owner with the continuous scene");
  declare_table_options(command, *options, "Files that Assimp reads, or generated scenes");
  command.run([options] {
    return make_table<Row>(
        *options,
        [](const std::string& scene, int n, ProgressBar& bar, std::vector<Row>& rows) {
          const Progress progress = bar.step(fmt::format("{}, n = {}", scene, n));
          const Bench bench(scene, n);
          const std::vector<NamedChoices> all = chapter5::all_choices();
          for (std::size_t i = 0; i < all.size(); ++i) {
            progress("choices", 0, static_cast<double>(i) / static_cast<double>(all.size()));
            rows.push_back(bench.measure(all[i]));
          }
        },
        print, to_csv);
  });
}

}  // namespace rc2
