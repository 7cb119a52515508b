// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Resample_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QRadioButton>
#include <QSpinBox>

#include <algorithm>
#include <limits>

namespace l0_cloudcompare {

using CGAL::L0_resampling::Method;

Resample_dialog::Resample_dialog(QWidget* parent, unsigned number_of_points, double radius,
                                 const Known_sides& known)
  : QDialog(parent), m_by_percentage(new QRadioButton(tr("&Percentage of the points"))),
    m_percentage(new QDoubleSpinBox), m_by_number(new QRadioButton(tr("&Number of points"))),
    m_number_of_points(new QSpinBox),
    m_automatic_radius(new QCheckBox(tr("&Automatic neighbor radius"))),
    m_neighbor_radius(new QDoubleSpinBox), m_method(new QComboBox), m_sides(new QComboBox),
    m_keep_outliers(new QCheckBox(tr("Keep &outliers"))),
    m_keep_density(new QCheckBox(tr("Keep &density")))
{
  setWindowTitle(tr("Resample (L0)"));
  m_by_percentage->setChecked(true);
  m_percentage->setRange(0.01, 100);
  m_percentage->setValue(Resample_options().percentage);
  m_percentage->setSuffix(" %");
  m_number_of_points->setRange(1, (std::numeric_limits<int>::max)());
  m_number_of_points->setValue((std::max)(1, int(number_of_points / 2)));
  m_number_of_points->setEnabled(false);
  m_automatic_radius->setChecked(true);
  m_automatic_radius->setToolTip(tr("By spacing and noise of the points"));
  m_neighbor_radius->setDecimals(6);
  m_neighbor_radius->setRange(1e-6, (std::numeric_limits<double>::max)());
  m_neighbor_radius->setValue(radius);
  m_neighbor_radius->setEnabled(false);
  m_neighbor_radius->setToolTip(tr("A length, in the unit of the points"));

  m_method->addItem(tr("Default"), int(Method::DEFAULT));
  m_method->addItem(tr("LOR, as in the paper"), int(Method::LOR));
  m_method->addItem(tr("ALOR, as in the paper"), int(Method::ALOR));

  m_sides->addItem(tr("Outwards"), int(Sides::OUTWARDS));
  if (known.has_sensor)
    m_sides->addItem(tr("To the sensor"), int(Sides::SENSOR));
  m_sides->addItem(tr("Up"), int(Sides::UP));
  if (known.has_normals)
    m_sides->addItem(tr("As the normals of the cloud"), int(Sides::NORMALS));

  m_keep_outliers->setToolTip(tr("Keep points off the cloud, which the default method leaves out"));
  m_keep_density->setToolTip(tr("As dense here and there as the cloud is, instead of even"));

  connect(m_by_number, &QRadioButton::toggled, m_number_of_points, &QWidget::setEnabled);
  connect(m_by_number, &QRadioButton::toggled, m_percentage, &QWidget::setDisabled);
  connect(m_automatic_radius, &QCheckBox::toggled, m_neighbor_radius, &QWidget::setDisabled);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

  auto* layout = new QFormLayout(this); // owns all controls
  layout->addRow(m_by_percentage, m_percentage);
  layout->addRow(m_by_number, m_number_of_points);
  layout->addRow(m_automatic_radius, m_neighbor_radius);
  layout->addRow(tr("&Method"), m_method);
  layout->addRow(tr("Side of the nor&mals"), m_sides);
  layout->addRow(m_keep_outliers);
  layout->addRow(m_keep_density);
  layout->addRow(buttons);
}

Resample_options Resample_dialog::options() const
{
  Resample_options options;
  options.percentage = m_percentage->value();
  if (m_by_number->isChecked())
    options.number_of_points = std::uint64_t(m_number_of_points->value());
  if (!m_automatic_radius->isChecked())
    options.neighbor_radius = m_neighbor_radius->value();
  options.method = Method(m_method->currentData().toInt());
  options.sides = Sides(m_sides->currentData().toInt());
  options.keep_outliers = m_keep_outliers->isChecked();
  options.keep_density = m_keep_density->isChecked();
  return options;
}

} // namespace l0_cloudcompare
