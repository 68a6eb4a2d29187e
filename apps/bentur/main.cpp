/// bentur, the command line: arguments, printing and exit statuses only; everything else is in the library.

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "arguments.h"
#include "bentur/core/version.h"
#include "bentur/io/output/output_rules.h"
#include "commands.h"
#include "session.h"

namespace bentur::cli {
namespace {

/// Parses the command line and runs the command it names. @return the exit status.
int run(int argc, char** argv) {
  CLI::App app{"bentur: seismic pounding of neighbouring buildings", "bentur"};
  app.set_version_flag("--version", fmt::format("bentur {}", version()));
  app.footer(
      "Examples:\n"
      "  bentur run                            the built-in example\n"
      "  bentur example two-frames-si -o mine  a case of your own to start from\n"
      "  bentur run mine/two-frames-si.toml -o results\n"
      "\nExit status: 0 done, 2 bad input, 3 the numbers failed, 1 anything else.\n"
      "Help on a command: bentur COMMAND --help");
  add_run_command(app);
  add_gap_command(app);
  add_report_command(app);
  add_sweep_command(app);
  add_ida_command(app);
  add_fragility_command(app);
  add_risk_command(app);
  add_remedy_command(app);
  add_sensitivity_command(app);
  add_modes_command(app);
  add_check_command(app);
  add_spectrum_command(app);
  add_plot_command(app);
  add_export_command(app);
  add_import_command(app);
  add_example_command(app);
  add_schema_command(app);
  app.require_subcommand(1);

  if (argc == 1) {
    message(app.help());
    return exit_bad_input;
  }
  const std::string first = argv[1];
  if (!first.starts_with("-") && !is_command(app, first)) {
    message(fmt::format("bentur: there is no command \"{}\"{}; bentur --help shows those there are", first,
                        meant_command(app, first)));
    return exit_bad_input;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    app.exit(help_or_version);
  } catch (const CLI::ExtrasError& error) {
    message(fmt::format("bentur: {}{}\nRun with --help for more information.", error.what(), meant_option(app)));
    return exit_bad_input;
  } catch (const CLI::ParseError& error) {
    message(std::string("bentur: ") + error.what() + "\nRun with --help for more information.");
    return exit_bad_input;
  } catch (const Failure& failure) {
    if (*failure.what() != '\0') message(failure.what());
    return failure.status();
  } catch (const RefusedOutput& error) {
    message(error.what());
    return exit_bad_input;
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    message("bentur: cannot write to standard output");
    return exit_other;
  }
  return exit_done;
}

}  // namespace
}  // namespace bentur::cli

namespace {

/// A stream that is closed would lend its number, and what is written to it, to the first file that is opened. Writing
/// to these places fails, as to a closed one.
void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) == -1)
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

}  // namespace

int main(int argc, char** argv) {
  keep_standard_streams();
  ::signal(SIGXFSZ, SIG_IGN);  // writing beyond a limit on the size of files fails then, as on a full disk
  try {
    return bentur::cli::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("bentur: the memory of this machine is not enough for this; bentur check CASE says what a run takes\n",
               stderr);
    return bentur::cli::exit_numbers_failed;
  } catch (const std::exception& error) {
    bentur::cli::message(std::string("bentur: ") + error.what());
  } catch (...) {
    std::fputs("bentur: unknown failure\n", stderr);
  }
  return bentur::cli::exit_other;
}
