#include "fem_reference/parallel.h"
#include "mpm/problem.h"
#include "verification/commands/commands.h"
#include "verification/run/version.h"
#include "verification/scene/read.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdio>
#include <functional>
#include <stdexcept>

namespace {

namespace commands = wetfront::verification::commands;
using wetfront::verification::read_settings;

constexpr const char* footer = R"(Examples:
  wetfront run verification/cases/seed_column/scene_3e-5.toml
  wetfront run verification/cases/seed_column/*.toml        several scenes, one index page
  wetfront explain verification/cases/dry_column/scene.toml
  wetfront study vary SCENE --set rain.intensity=1e-5,2e-5 --set mpm.points_per_cell=4,9
  wetfront study safety verification/cases/small_slope/scene.toml --times 0,60,120,180
  wetfront new my_slope.toml

Exit codes: 0 all pass, 1 a comparison failed, 2 bad input, 3 a solver gave up, 4 inconclusive.)";

/// What every command can throw ends here as a message and an exit code.
int guarded(const std::function<int()>& command) {
  try {
    return command();
  } catch (const wetfront::verification::SceneError& error) {
    for (const std::string& message : error.messages) fmt::print(stderr, "{}\n", message);
  } catch (const std::exception& error) {
    fmt::print(stderr, "wetfront: {}\n", error.what());
  }
  return 2;
}

struct Arguments {
  commands::Paths scenes;
  std::vector<std::string> settings;
  std::filesystem::path scene, folder, out, declaration;
  std::string name, suite, only, accuracy;
  bool resume = false, page = false, slide = false, no_store = false, heavy = false;
  wetfront::verification::ReferenceStore store{"out/.references"};
};

/// "1%", "1 %" or "0.01"; 0 for nothing. Throws std::invalid_argument.
double fraction(const std::string& text) {
  if (text.empty()) return 0;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string unit(end, text.data() + text.size());
  std::erase(unit, ' ');
  if (unit == "%") value /= 100;
  if (error != std::errc{} || (!unit.empty() && unit != "%") || !(value > 0 && value < 1))
    throw std::invalid_argument("--accuracy " + text +
                                " is no accuracy (a relative error between 0 and 1 is meant). Write e.g. 1% or 0.01");
  return value;
}

/// What every study takes.
void add_study(CLI::App* study, commands::StudyRequest& request) {
  study->add_option("SCENE", request.scene, "scene file (.toml)")->required();
  study->add_option("--out", request.out, "output folder (default out/study_<kind>_<scene>)");
}

/// What a study of several points takes.
void add_points(CLI::App* study, commands::StudyRequest& request) {
  auto* jobs = study->add_option("--jobs", request.jobs, "points at a time (default: one per processor)")
                   ->check(CLI::PositiveNumber);
  auto* list = study->add_flag("--list", request.list, "show the points and their numbers, run nothing");
  auto* point = study->add_option("--point", request.point, "compute this point alone: for job arrays")
                    ->check(CLI::NonNegativeNumber)
                    ->excludes(list);
  study->add_flag("--gather", request.gather, "write the page from points computed with --point")
      ->excludes(list, point, jobs);
}

/// Where solutions of the reference are kept between runs.
void add_store(CLI::App* command, Arguments& arguments) {
  auto* folder = command->add_option("--references", arguments.store.folder,
                                     "folder of computed references, taken again when the problem and the code are the "
                                     "same (default out/.references)");
  command->add_flag("--no-store", arguments.no_store, "compute every reference anew and keep none")->excludes(folder);
}

CLI::Option* add_settings(CLI::App* command, std::vector<std::string>& settings) {
  return command
      ->add_option("--set", settings,
                   "PATH=VALUE: a value of the scene set anew, e.g. rain.intensity=2e-5; no value leaves a key or "
                   "section out")
      ->allow_extra_args(false);
}

CLI::Option* add_scenes(CLI::App* command, Arguments& arguments) {
  return command->add_option("SCENE", arguments.scenes, "scene files (.toml)")->required();
}

}  // namespace

int main(int argc, char** argv) {
  const wetfront::fem_reference::Parallel
      parallel;  // under mpirun rank 0 runs the program, the others serve its solves
  if (!parallel.leads()) return parallel.serve();
  CLI::App app{
      "Verifies a material point method for rainfall-induced landslides against a finite-element Richards reference."};
  app.name("wetfront");
  app.footer(footer);
  app.set_version_flag("--version", std::string("wetfront ") + wetfront::verification::version::number + " (" +
                                        wetfront::verification::version::git_hash + ")");
  app.require_subcommand(1);
  Arguments arguments;
  std::function<int()> command;
  const auto add = [&](const char* name, const char* help, std::function<int()> action) {
    CLI::App* subcommand = app.add_subcommand(name, help);
    subcommand->callback([&command, action = std::move(action)] { command = action; });
    return subcommand;
  };

  const auto store = [&] { return arguments.no_store ? wetfront::verification::ReferenceStore{} : arguments.store; };

  commands::RunRequest run_request;
  auto* run = add("run", "mesh -> reference -> MPM -> comparison -> report", [&] {
    run_request.options.store = store();
    run_request.options.accuracy = fraction(arguments.accuracy);
    run_request.options.resume = arguments.resume;
    return commands::run(arguments.scenes, arguments.out, run_request);
  });
  add_scenes(run, arguments);
  run->add_option("--out", arguments.out, "output folder (default out/<scene>; with several scenes the folder above)");

  run->add_flag("--resume", arguments.resume, "go on from the checkpoint that a stopped run has left in its folder");
  run->add_option("--checkpoint", run_request.options.checkpoint_every,
                  "seconds of wall time between the states that --resume can go on from (default 60)")
      ->check(CLI::NonNegativeNumber);
  run->add_option(
      "--accuracy", arguments.accuracy,
      "the cheapest setting of a stored study of accuracy whose error is within this, e.g. 1%; without a study, "
      "cells and time steps of the MPM are refined until its own estimated error is");
  auto* quantity = run->add_option("--quantity", run_request.quantity,
                                   "what the accuracy is meant of (default pressure_l2); needs a study")
                       ->needs("--accuracy");
  auto* kept_study =
      run->add_option("--study", run_request.study, "folder of that study (default out/study_accuracy_<scene>)")
          ->needs("--accuracy");
  add_settings(run, run_request.settings)
      ->excludes(quantity, kept_study);  // a study is of the scene as its file has it
  run->add_flag("--ledger", run_request.options.ledger,
                "also where the differences come from, whatever it costs (unasked where it costs 5 CPU-s or less)");
  run_request.options.ledger_where_cheap = true;
  run->add_flag_callback(
      "--no-ledger", [&] { run_request.options.ledger_where_cheap = false; },
      "not where the differences come from, even where it costs little");
  add_store(run, arguments);

  auto* explain = add("explain", "effects and what called for them, columns, step limits, cost; runs nothing",
                      [&] { return commands::explain(arguments.scenes, read_settings(arguments.settings)); });
  auto* check = add("check", "read and cross-check only",
                    [&] { return commands::check(arguments.scenes, read_settings(arguments.settings)); });
  for (CLI::App* one : {explain, check}) {
    add_scenes(one, arguments);
    add_settings(one, arguments.settings);
  }

  auto* reference = add("reference", "the finite-element solution alone, with its own error",
                        [&] { return commands::reference(arguments.scene, arguments.out, store()); });
  reference->add_option("SCENE", arguments.scene, "scene file (.toml)")->required();
  reference->add_option("--out", arguments.out, "output folder (default out/<scene>_reference)");
  add_store(reference, arguments);

  auto* verify = add("verify", "the suites of closed forms and cases",
                     [&] { return commands::verify(arguments.suite, arguments.out, arguments.heavy, arguments.only); });
  verify->add_option("SUITE", arguments.suite, fmt::format("{}", fmt::join(commands::suite_names(), ", ")))->required();
  verify->add_option("--out", arguments.out, "output folder (default out/verify_<suite>)");
  verify->add_flag("--heavy", arguments.heavy, "also the cases that take long (minutes in all)");
  verify->add_option("--only", arguments.only, "only cases whose name contains this");

  CLI::App* study = app.add_subcommand(
      "study", "sweeps: what varies, what accuracy costs, which effects matter, how safe a slope is");
  study->require_subcommand(1);
  commands::StudyRequest request;
  double budget = 20;
  request.command.assign(argv + 1, argv + argc);
  auto* vary = study->add_subcommand("vary", "any scene value swept, several at once");
  vary->callback([&] {
    command = [&] {
      request.store = store();
      return commands::study_vary(request);
    };
  });
  add_study(vary, request);
  add_points(vary, request);
  vary->add_option("--set", request.settings,
                   "PATH=V1,V2,...: e.g. rain.intensity=1e-5,2e-5 or soil[sand].porosity=0.4")
      ->required()
      ->allow_extra_args(false);
  add_store(vary, arguments);

  const auto add_kind = [&](const char* name, const char* help, std::function<int()> action) {
    auto* kind = study->add_subcommand(name, help);
    kind->callback([&, action = std::move(action)] {
      command = [&, action] {
        request.store = store();
        return action();
      };
    });
    add_study(kind, request);
    add_store(kind, arguments);
    return kind;
  };
  auto* accuracy = add_kind("accuracy", "error over CPU seconds: schemes, cells, tolerances, points per cell",
                            [&] { return commands::study_accuracy(request, budget); });
  add_points(accuracy, request);
  accuracy->add_option("--budget", budget, "CPU seconds that one point may be expected to cost (default 20)");
  auto* effects = add_kind("effects", "each effect left out or added in turn: which the scene needs",
                           [&] { return commands::study_effects(request, budget); });
  add_points(effects, request);
  effects->add_option("--budget", budget, "CPU seconds that one point may be expected to cost (default 20)");
  std::vector<double> safety_times;
  wetfront::mpm::SafetySearch search;
  auto* safety = study->add_subcommand("safety", "the factor of safety over time: strength reduction, infinite slope");
  safety->callback([&] { command = [&] { return commands::study_safety(request, safety_times, search); }; });
  add_study(safety, request);
  safety
      ->add_option("--times", safety_times,
                   "seconds, with commas; and at failure (default: ten even parts of the quasi-static stages)")
      ->delimiter(',');
  safety->add_option("--tolerance", search.tolerance, "width of the last bracket of a factor (default 0.01)");
  safety->add_option("--largest", search.largest, "a slope that stands at this is not weakened further (default 4)");
  add_kind("difference", "where the difference between MPM and reference comes from",
           [&] { return commands::study_difference(request); });

  auto* compare = add("compare", "another code's stored result against a scene's reference", [&] {
    return commands::compare(arguments.scene, arguments.declaration, arguments.out, store());
  });
  compare->add_option("SCENE", arguments.scene, "scene file (.toml) whose reference counts")->required();
  compare
      ->add_option("RESULT", arguments.declaration,
                   "declaration (.result, TOML) of the result: its files, times, arrays, units and signs")
      ->required();
  compare->add_option("--out", arguments.out, "output folder (default out/compare_<result>)");
  add_store(compare, arguments);

  auto* report =
      add("report", "render a result folder again from its result.json, or the page over a folder of results",
          [&] { return commands::report(arguments.folder); });
  report->add_option("DIR", arguments.folder, "folder with a result.json, or with folders that have one")->required();

  auto* fresh = add("new", "write a commented scene to start from",
                    [&] { return commands::new_scene(arguments.name, arguments.slide); });
  fresh->add_option("NAME", arguments.name, "file to write, e.g. my_slope.toml")->required();
  fresh->add_flag("--slide", arguments.slide, "a slope from the first rain to the end of its slide, not a column");

  auto* schema = add("schema", "print the JSON Schema of a scene", [&] { return commands::schema(arguments.page); });
  schema->add_flag("--page", arguments.page, "print the key reference as Markdown instead");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return guarded(command);
}
