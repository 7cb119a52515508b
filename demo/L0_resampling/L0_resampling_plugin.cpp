// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Scene_points_with_normal_item.h"
#include "ui_L0_resampling_plugin.h"

#include <CGAL/Three/CGAL_Lab_plugin_helper.h>
#include <CGAL/Three/CGAL_Lab_plugin_interface.h>
#include <CGAL/Three/Three.h>
#include <CGAL/l0_resample_point_set.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QMainWindow>
#include <QProgressDialog>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <future>
#include <iterator>
#include <limits>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace {

using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented_points = std::vector<std::pair<Point, Vector>>;

/// What is asked for.
struct Options
{
  CGAL::L0_resampling::Method method = CGAL::L0_resampling::Method::DEFAULT;
  std::size_t number_of_output_points = 0;
  std::optional<double> neighbor_radius; ///< none: from spacing and noise, or as in the paper
  std::size_t number_of_threads = 1;
};

class L0_resampling_dialog : public QDialog, private Ui::L0_resampling_dialog
{
  Q_OBJECT

public:
  /// \param neighbor_radius what is shown while the radius is automatic
  L0_resampling_dialog(QWidget* parent, std::size_t number_of_points, double neighbor_radius)
    : QDialog(parent)
  {
    setupUi(this);
    m_method->addItem(tr("Default"), int(CGAL::L0_resampling::Method::DEFAULT));
    m_method->addItem(tr("LOR, as in the paper"), int(CGAL::L0_resampling::Method::LOR));
    m_method->addItem(tr("ALOR, as in the paper"), int(CGAL::L0_resampling::Method::ALOR));
    const std::size_t most = (std::min)(number_of_points,
                                        std::size_t((std::numeric_limits<int>::max)()));
    m_numberOfPoints->setRange(1, int(most));
    m_numberOfPoints->setValue(int((most + 1) / 2));
    m_neighborRadius->setValue(neighbor_radius);
    const int number_of_cores = (std::max)(1, int(std::thread::hardware_concurrency()));
    m_numberOfThreads->setRange(1, number_of_cores);
    m_numberOfThreads->setValue(number_of_cores);
#ifndef CGAL_LINKED_WITH_TBB
    m_numberOfThreads->setRange(1, 1);
#endif
  }

  Options options() const
  {
    Options options;
    options.method = CGAL::L0_resampling::Method(m_method->currentData().toInt());
    options.number_of_output_points = std::size_t(m_numberOfPoints->value());
    if (!m_automaticRadius->isChecked())
      options.neighbor_radius = m_neighborRadius->value();
    options.number_of_threads = std::size_t(m_numberOfThreads->value());
    return options;
  }
};

Oriented_points resample(const Point_set& points, const Options& options,
                         const std::function<bool(double)>& callback)
{
  namespace parameters = CGAL::parameters;
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  options.number_of_threads);
#endif
  Oriented_points result;
  const auto call = [&](const auto& np) {
    CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
      points.all_or_selection_if_not_empty(), std::back_inserter(result), np);
  };
  const auto np = parameters::resampling_method(options.method)
                    .number_of_output_points(options.number_of_output_points)
                    .callback(callback)
                    .point_map(points.point_map())
                    .geom_traits(Kernel());
  if (options.neighbor_radius)
    call(np.neighbor_radius(*options.neighbor_radius));
  else
    call(np);
  return result;
}

/// Resamples beside the window, which shows the progress and can cancel.
/// \returns nothing if it was cancelled
std::optional<Oriented_points> resample_with_progress_dialog(const Point_set& points,
                                                             const Options& options,
                                                             QMainWindow* window)
{
  QProgressDialog dialog(QObject::tr("L0 resampling..."), QObject::tr("Cancel"), 0, 100, window);
  dialog.setWindowModality(Qt::WindowModal);
  dialog.setMinimumDuration(500);

  std::atomic<int> percent(0);
  std::atomic<bool> is_canceled(false);
  const auto callback = [&](double share) {
    percent = int(100 * share);
    return !is_canceled;
  };
  std::future<Oriented_points> result =
    std::async(std::launch::async, [&]() { return resample(points, options, callback); });
  while (result.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
  {
    dialog.setValue((std::min)(percent.load(), 99)); // the last one closes the dialog
    QApplication::processEvents();
    is_canceled = dialog.wasCanceled();
  }
  Oriented_points resampled = result.get();
  if (is_canceled)
    return std::nullopt;
  return resampled;
}

} // namespace

class CGAL_Lab_l0_resampling_plugin : public QObject, public CGAL::Three::CGAL_Lab_plugin_helper
{
  Q_OBJECT
  Q_INTERFACES(CGAL::Three::CGAL_Lab_plugin_interface)
  Q_PLUGIN_METADATA(IID "com.geometryfactory.CGALLab.PluginInterface/1.0")

  QAction* actionL0Resampling;

public:
  void init(QMainWindow* window, CGAL::Three::Scene_interface* scene_interface,
            Messages_interface*) override
  {
    mw = window;
    scene = scene_interface;
    actionL0Resampling = new QAction(tr("L0 Resampling"), window);
    actionL0Resampling->setProperty("subMenuName", "Point Set Processing");
    actionL0Resampling->setObjectName("actionL0Resampling"); // names the slot that is connected
    autoConnectActions();
  }

  QList<QAction*> actions() const override { return {actionL0Resampling}; }

  bool applicable(QAction*) const override { return selected_item() != nullptr; }

public Q_SLOTS:
  void on_actionL0Resampling_triggered()
  {
    Scene_points_with_normal_item* item = selected_item();
    if (!item || !item->point_set())
      return;
    const Point_set& points = *item->point_set();
    const std::size_t number_of_points = points.all_or_selection_if_not_empty().size();
    const double radius_of_the_paper = item->bboxDiagonal() / std::cbrt(double(number_of_points));
    L0_resampling_dialog dialog(mw, number_of_points, radius_of_the_paper);
    if (dialog.exec() != QDialog::Accepted)
      return;
    try
    {
      if (const std::optional<Oriented_points> result =
            resample_with_progress_dialog(points, dialog.options(), mw))
        add_item(*item, *result);
    }
    catch (const std::exception& error)
    {
      CGAL::Three::Three::error(tr("L0 Resampling"), QString::fromStdString(error.what()));
    }
  }

private:
  Scene_points_with_normal_item* selected_item() const
  {
    return qobject_cast<Scene_points_with_normal_item*>(scene->item(scene->mainSelectionIndex()));
  }

  void add_item(Scene_points_with_normal_item& item, const Oriented_points& points)
  {
    Scene_points_with_normal_item* new_item =
      new Scene_points_with_normal_item(); // the scene owns it
    new_item->setName(tr("%1 (L0 resampled)").arg(item.name()));
    new_item->point_set()->add_normal_map();
    for (const auto& [point, normal] : points)
      new_item->point_set()->insert(point, normal);
    new_item->invalidateOpenGLBuffers();
    item.setVisible(false);
    scene->addItem(new_item);
  }
};

#include "L0_resampling_plugin.moc"
