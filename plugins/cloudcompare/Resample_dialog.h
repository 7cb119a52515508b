// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_CLOUDCOMPARE_RESAMPLE_DIALOG_H
#define L0_CLOUDCOMPARE_RESAMPLE_DIALOG_H

#include "Resample_options.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QRadioButton;
class QSpinBox;

namespace l0_cloudcompare {

/// What a cloud has that sides can follow.
struct Known_sides
{
  bool has_sensor = false;
  bool has_normals = false;
};

/// Asks for the options of a resampling.
class Resample_dialog : public QDialog
{
public:
  /// \param number_of_points of the cloud
  /// \param radius what is proposed where a radius is typed
  Resample_dialog(QWidget* parent, unsigned number_of_points, double radius,
                  const Known_sides& known);

  Resample_options options() const;

private:
  QRadioButton* m_by_percentage;
  QDoubleSpinBox* m_percentage;
  QRadioButton* m_by_number;
  QSpinBox* m_number_of_points;
  QCheckBox* m_automatic_radius;
  QDoubleSpinBox* m_neighbor_radius;
  QComboBox* m_method;
  QComboBox* m_sides;
  QCheckBox* m_keep_outliers;
  QCheckBox* m_keep_density;
};

} // namespace l0_cloudcompare

#endif // L0_CLOUDCOMPARE_RESAMPLE_DIALOG_H
