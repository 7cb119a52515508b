// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_CLOUDCOMPARE_QL0_RESAMPLE_H
#define L0_CLOUDCOMPARE_QL0_RESAMPLE_H

#include <ccStdPluginInterface.h>

#include <QObject>

class QAction;
class ccPointCloud;

/// The plugin: an item of the menu, and a command.
class QL0_resample : public QObject, public ccStdPluginInterface
{
  Q_OBJECT
  Q_INTERFACES(ccPluginInterface ccStdPluginInterface)
  Q_PLUGIN_METADATA(IID "cgal.cloudcompare.plugin.L0Resample" FILE "info.json")

public:
  explicit QL0_resample(QObject* parent = nullptr);

  void onNewSelection(const ccHObject::Container& selected) override;
  QList<QAction*> getActions() override;
  void registerCommands(ccCommandLineInterface* commands) override;

private:
  void resample_selection();
  void say(const ccPointCloud& cloud, const QString& text,
           ccMainAppInterface::ConsoleMessageLevel level);

  QAction* m_action;
};

#endif // L0_CLOUDCOMPARE_QL0_RESAMPLE_H
