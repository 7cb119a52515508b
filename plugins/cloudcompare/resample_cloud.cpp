// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "resample_points.h" // before Qt, whose macro emit() hides a function of TBB

#include "resample_cloud.h"

#include <CGAL/L0_resampling/warnings.h>

#include <ReferenceCloud.h>
#include <ccPointCloud.h>

#include <QCoreApplication>
#include <QProgressDialog>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <new>

// The namespace of CloudCompare's core, up to version 2.11 and since
namespace CCLib {}
namespace CCCoreLib {}

namespace l0_cloudcompare {
namespace {

using namespace CCLib;
using namespace CCCoreLib;

/// Resamples beside the window, which shows the progress and can cancel.
Resampled_points resample_beside_window(const ccPointCloud& cloud, const Resample_options& options,
                                        QProgressDialog& progress)
{
  std::atomic<int> percent(0);
  std::atomic<bool> is_cancelled(false);
  const auto callback = [&](double share) {
    percent = int(100 * share);
    return !is_cancelled;
  };
  progress.setRange(0, 100);
  progress.setLabelText(QObject::tr("L0 resampling..."));
  progress.show();
  std::future<Resampled_points> result =
    std::async(std::launch::async, [&]() { return resample_points(cloud, options, callback); });
  while (result.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
  {
    progress.setValue((std::min)(percent.load(), 99)); // the last one closes the dialog
    QCoreApplication::processEvents();
    is_cancelled = progress.wasCanceled();
  }
  return result.get();
}

/// The points of the result as a cloud, with all that `cloud` knows of their sources.
std::unique_ptr<ccPointCloud> cloud_of(ccPointCloud& cloud, const Resampled_points& resampled)
{
  const unsigned size = unsigned(resampled.points.size());
  ReferenceCloud sources(&cloud);
  if (!sources.reserve(size))
    throw std::bad_alloc();
  for (const unsigned source : resampled.sources)
    sources.addPointIndex(source);
  std::unique_ptr<ccPointCloud> result(cloud.partialClone(&sources));
  if (!result || !result->resizeTheNormsTable())
    throw std::bad_alloc();
  for (unsigned i = 0; i < size; ++i)
  {
    const auto& [p, n] = resampled.points[i];
    *const_cast<CCVector3*>(result->getPoint(i)) = // as CloudCompare itself moves points
      CCVector3(PointCoordinateType(p.x()), PointCoordinateType(p.y()), PointCoordinateType(p.z()));
    result->setPointNormal(i, CCVector3(PointCoordinateType(n.x()), PointCoordinateType(n.y()),
                                        PointCoordinateType(n.z())));
  }
  result->invalidateBoundingBox();
  result->showNormals(true);
  result->setName(QObject::tr("%1 (L0 resampled)").arg(cloud.getName()));
  return result;
}

} // namespace

std::unique_ptr<ccPointCloud> resample_cloud(ccPointCloud& cloud, const Resample_options& options,
                                             QProgressDialog* progress, QStringList& warnings)
{
  const Resampled_points resampled = progress ? resample_beside_window(cloud, options, *progress)
                                              : resample_points(cloud, options, nullptr);
  if (resampled.report.outcome == CGAL::L0_resampling::Outcome::CANCELLED)
    return nullptr;
  for (const CGAL::L0_resampling::Warning warning : CGAL::L0_resampling::warnings(resampled.report))
    warnings += QString::fromStdString(message_of(warning, resampled.report));
  return cloud_of(cloud, resampled);
}

} // namespace l0_cloudcompare
