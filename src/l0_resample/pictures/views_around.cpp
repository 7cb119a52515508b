// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/views_around.h"

#include "pictures/Camera.h"

#include <cstddef>

namespace l0_tool {

std::vector<View> views_around(const View& view, int number)
{
  const Vector towards_eye = normalized(view.towards_eye),
               above = upwards_in_picture(towards_eye, view.up),
               upright = (towards_eye * above) * above, horizontal = towards_eye - upright;
  std::vector<View> views(std::size_t(maximum_number_of_views), view);
  views[1].towards_eye = upright - horizontal;
  views[1].up = above;
  views[2].towards_eye = above;
  views[3].towards_eye = -above;
  views[2].up = views[3].up = -horizontal;
  views.resize(std::size_t(number));
  return views;
}

} // namespace l0_tool
