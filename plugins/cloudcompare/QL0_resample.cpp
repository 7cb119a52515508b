// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "QL0_resample.h"

#include "Resample_command.h"
#include "Resample_dialog.h"
#include "resample_cloud.h"
#include "sensors.h"

#include <ccHObjectCaster.h>
#include <ccPointCloud.h>

#include <QAction>
#include <QMainWindow>
#include <QProgressDialog>

#include <cmath>
#include <exception>
#include <memory>
#include <vector>

namespace {

using namespace l0_cloudcompare;

/// Those of the entities that are clouds and have points.
std::vector<ccPointCloud*> clouds_of(const ccHObject::Container& entities)
{
  std::vector<ccPointCloud*> clouds;
  for (ccHObject* entity : entities)
    if (entity->isA(CC_TYPES::POINT_CLOUD))
    {
      ccPointCloud* cloud = ccHObjectCaster::ToPointCloud(entity);
      if (cloud && cloud->size() > 0)
        clouds.push_back(cloud);
    }
  return clouds;
}

} // namespace

QL0_resample::QL0_resample(QObject* parent)
  : QObject(parent), ccStdPluginInterface(":/CC/plugin/qL0Resample/info.json"),
    m_action(new QAction(tr("Resample (L0)"), this))
{
  m_action->setToolTip(getDescription());
  m_action->setEnabled(false);
  connect(m_action, &QAction::triggered, this, &QL0_resample::resample_selection);
}

void QL0_resample::onNewSelection(const ccHObject::Container& selected)
{
  m_action->setEnabled(!clouds_of(selected).empty());
}

QList<QAction*> QL0_resample::getActions() { return {m_action}; }

void QL0_resample::registerCommands(ccCommandLineInterface* commands)
{
  commands->registerCommand(
    ccCommandLineInterface::Command::Shared(new l0_cloudcompare::Resample_command));
}

void QL0_resample::say(const ccPointCloud& cloud, const QString& text,
                       ccMainAppInterface::ConsoleMessageLevel level)
{
  m_app->dispToConsole(QString("[L0 resampling] %1: %2").arg(cloud.getName(), text), level);
}

void QL0_resample::resample_selection()
{
  const std::vector<ccPointCloud*> clouds = clouds_of(m_app->getSelectedEntities());
  if (clouds.empty())
    return;
  ccPointCloud& first = *clouds.front();
  const double radius_of_the_paper = double(first.getOwnBB().getDiagNorm())
                                     / std::cbrt(double(first.size()));
  Resample_dialog dialog(m_app->getMainWindow(), first.size(), radius_of_the_paper,
                         {number_of_sensors(first) > 0, first.hasNormals()});
  if (dialog.exec() != QDialog::Accepted)
    return;
  for (ccPointCloud* cloud : clouds)
    try
    {
      QProgressDialog progress(m_app->getMainWindow());
      progress.setWindowModality(Qt::ApplicationModal); // nothing changes the cloud meanwhile
      QStringList warnings;
      std::unique_ptr<ccPointCloud> result = resample_cloud(*cloud, dialog.options(), &progress,
                                                            warnings);
      if (!result)
      {
        say(*cloud, tr("cancelled"), ccMainAppInterface::WRN_CONSOLE_MESSAGE);
        break;
      }
      for (const QString& warning : warnings)
        say(*cloud, warning, ccMainAppInterface::WRN_CONSOLE_MESSAGE);
      cloud->setEnabled(false);
      if (ccHObject* parent = cloud->getParent())
        parent->addChild(result.get());
      m_app->addToDB(result.release()); // which owns it
    }
    catch (const std::exception& error)
    {
      say(*cloud, error.what(), ccMainAppInterface::ERR_CONSOLE_MESSAGE);
    }
  m_app->redrawAll();
}
