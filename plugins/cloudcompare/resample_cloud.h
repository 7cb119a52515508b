// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_CLOUDCOMPARE_RESAMPLE_CLOUD_H
#define L0_CLOUDCOMPARE_RESAMPLE_CLOUD_H

#include "Resample_options.h"

#include <QStringList>

#include <memory>

class ccPointCloud;
class QProgressDialog;

namespace l0_cloudcompare {

/*!
Resamples a cloud to a new one with normals. Colors, scalar fields and all else that points have are
those of the nearest point of `cloud`: its scalar fields may be labels, of which there is no mean.

\param progress shows the progress and can cancel; none: `nullptr`
\param warnings what `CGAL::L0_resampling::warnings()` says of the result
\returns `nullptr` if it was cancelled
\throws what `resample_points()` throws, and std::bad_alloc if there is no memory for the new cloud
*/
std::unique_ptr<ccPointCloud> resample_cloud(ccPointCloud& cloud, const Resample_options& options,
                                             QProgressDialog* progress, QStringList& warnings);

} // namespace l0_cloudcompare

#endif // L0_CLOUDCOMPARE_RESAMPLE_CLOUD_H
