// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/Failure.h"
#include "basis/messages.h"
#include "basis/signals.h"
#include "command_line/options.h"
#include "tasks/report_json.h"
#include "tasks/run.h"
#include "tiles/run_as_one.h"

#include <optional>

namespace {

using namespace l0_tool;

Exit_status run_alone(const Options& options)
{
  Run_record record = run(options);
  if (!options.json.empty() && !options.dry_run && !is_interrupted())
    guarded(record, [&]() { write_text(options.json, report_as_json(options, record)); });
  print_outcome(options, record);
  print_error(record.error);
  return record.status;
}

} // namespace

int main(int argc, char** argv)
{
  Command command;
  if (const std::optional<int> status = parse_command_line(argc, argv, command))
    return *status;
  catch_signals(command.runs.front().timeout);
  if (command.tiles.is_as_one)
    return run_as_one(command);
  return command.is_batch() ? run_batch(command) : run_alone(command.runs.front());
}
