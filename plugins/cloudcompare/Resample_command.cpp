// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Resample_command.h"

#include "parse_options.h"
#include "resample_cloud.h"

#include <ccProgressDialog.h>

#include <exception>
#include <memory>

namespace l0_cloudcompare {
namespace {

/// \returns whether the cloud was replaced, and saved where that is asked for
bool resample(CLCloudDesc& description, const Resample_options& options,
              ccCommandLineInterface& commands)
{
  std::unique_ptr<ccProgressDialog> progress;
  if (!commands.silentMode())
    progress = std::make_unique<ccProgressDialog>(true, commands.widgetParent());
  const QString name = description.pc->getName();
  QStringList warnings;
  std::unique_ptr<ccPointCloud> result = resample_cloud(*description.pc, options, progress.get(),
                                                        warnings);
  if (!result)
    return commands.error(QObject::tr("[L0 resampling] %1: cancelled").arg(name));
  for (const QString& warning : warnings)
    commands.warning(QString("[L0 resampling] %1: %2").arg(name, warning));
  commands.print(QObject::tr("[L0 resampling] %1: %2 of %3 points")
                   .arg(name)
                   .arg(result->size())
                   .arg(description.pc->size()));
  delete description.pc;
  description.pc = result.release(); // which CloudCompare deletes
  description.basename += "_L0_RESAMPLED";
  if (!commands.autoSaveMode())
    return true;
  const QString error = commands.exportEntity(description);
  return error.isEmpty() || commands.error(error);
}

} // namespace

Resample_command::Resample_command()
  : ccCommandLineInterface::Command("L0 resampling", "L0_RESAMPLE")
{}

bool Resample_command::process(ccCommandLineInterface& commands)
{
  commands.print("[L0 RESAMPLING]");
  try
  {
    const Resample_options options = parse_options(commands.arguments());
    if (commands.clouds().empty())
      return commands.error(
        QObject::tr("[L0 resampling] there is no cloud, -O opens one before this command"));
    for (CLCloudDesc& description : commands.clouds())
      if (!resample(description, options, commands))
        return false;
  }
  catch (const std::exception& error)
  {
    return commands.error(QString("[L0 resampling] %1").arg(error.what()));
  }
  return true;
}

} // namespace l0_cloudcompare
