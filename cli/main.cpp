// SPDX-License-Identifier: MIT
// The program arete: reads the command line, runs the job, and is the one place that prints errors
// and chooses the exit code: 0 done, 1 failed, 2 misuse, 130 interrupted.
#include <iostream>
#include <new>

#include "arete/field/error.h"
#ifdef ARETE_HAVE_GDAL
#include "arete/gdal/remote.h"
#endif
#include "arete/scheme/error.h"
#include "cli/build_info.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/verb.h"

namespace {

int complain(const std::string& message, int code) {
  std::cout.flush();
  std::cerr << "arete: " << message << '\n';
  return code;
}

bool has_verb(const CLI::App& program, const std::string& name) {
  for (const CLI::App* verb : program.get_subcommands({}))
    if (verb->check_name(name)) return true;
  return false;
}

int run(int argc, char** argv) {
  using namespace arete;
  CLI::App program{
      "Parametric subdivision for terrain: fine surfaces from coarse grids, from "
      "gentle to craggy,\nwith a statement of how smooth they are."};
  program.name("arete");
  program.set_version_flag("--version", cli::build_info());
  program.require_subcommand(1);
  program.failure_message(CLI::FailureMessage::simple);
  program.get_formatter()->column_width(34);
  // Options of the program may follow the verb.
  program.fallthrough();
  bool allow_remote = false;
  program.add_flag("--allow-remote", allow_remote, "Let inputs lie on a network (/vsicurl/, URLs)");
  cli::Job job;
  cli::add_schemes(program, job);
  cli::add_describe(program, job);
  cli::add_analyze(program, job);
  cli::add_map(program, job);
  cli::add_curve(program, job);
  cli::add_ifs(program, job);
  cli::add_spline(program, job);
  cli::add_minimal(program, job);
  cli::add_grid(program, job);
  cli::add_refine(program, job);
  cli::add_coarsen(program, job);
  cli::add_restore(program, job);
  cli::add_contour(program, job);
  cli::add_compare(program, job);
  cli::add_fit(program, job);
  cli::add_render(program, job);
  cli::add_generate(program, job);
  cli::add_validate(program, job);
  if (argc > 1 && argv[1][0] != '-' && !has_verb(program, argv[1]))
    return complain("there is no verb '" + std::string(argv[1]) + "'; see 'arete --help'", 2);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    std::string verb;
    for (const CLI::App* sub : program.get_subcommands()) verb = " " + sub->get_name();
    return complain(std::string(error.what()) + "; see 'arete" + verb + " --help'", 2);
  }
#ifdef ARETE_HAVE_GDAL
  gdal::forbid_programs();
  if (!allow_remote) gdal::forbid_remote_access();
#endif
  cli::catch_interruptions();
  job();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const arete::cli::Interrupted& error) {
    return complain(error.what(), 130);
  } catch (const arete::cli::Misuse& error) {
    return complain(error.what(), 2);
  } catch (const arete::InvalidScheme& error) {
    return complain(error.what(), 2);
  } catch (const arete::InvalidField& error) {
    return complain(error.what(), 2);
  } catch (const std::bad_alloc&) {
    return complain("out of memory; use fewer levels or a smaller input", 1);
  } catch (const std::exception& error) {
    return complain(error.what(), 1);
  }
}
