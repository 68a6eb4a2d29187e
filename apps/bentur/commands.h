#pragma once

#include <CLI/CLI.hpp>

namespace bentur::cli {

/// Each adds its subcommand; parsing the command line then runs it.
void add_example_command(CLI::App& app);
void add_run_command(CLI::App& app);
void add_modes_command(CLI::App& app);
void add_gap_command(CLI::App& app);
void add_report_command(CLI::App& app);
void add_sweep_command(CLI::App& app);
void add_ida_command(CLI::App& app);
void add_fragility_command(CLI::App& app);
void add_risk_command(CLI::App& app);
void add_remedy_command(CLI::App& app);
void add_sensitivity_command(CLI::App& app);
void add_check_command(CLI::App& app);
void add_spectrum_command(CLI::App& app);
void add_plot_command(CLI::App& app);
void add_schema_command(CLI::App& app);
void add_export_command(CLI::App& app);
void add_import_command(CLI::App& app);

}  // namespace bentur::cli
