// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers of XYZ, CSV and PTS: what stands in a text is read, whatever separates it.

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

void test_xyz()
{
  CHECK(read(".xyz", "# x y z\n1 2 3\n\n\t-1e1\t+0.5 3 \r\n4 5 6").points
        == (std::vector<Point>{Point(1, 2, 3), Point(-10, .5, 3), Point(4, 5, 6)}));
  CHECK(read(".pwn", "2\n1 2 3 0 0 1\n7 8 9 .6 -.8 0\n", with_normals()).normals
        == (std::vector<Vector>{Vector(0, 0, 1), Vector(.6, -.8, 0)}));
  CHECK(read(".xyz", "1 2 3 a\n1 2 3 b\n", with_normals()).normals.empty());
  CHECK(read(".xyz", "1\n1 2 3\n4 5 6\n").warnings.size() == 1);
  CHECK(read(".xyz", "0\n").points.empty());
  CHECK(refusal(".xyz", "").says("line 1: the file has no points"));
  CHECK(refusal(".xyz", "# x y z\n\n").status == INPUT_REFUSED);
}

std::string repeated(int times, const std::string& line)
{
  std::string text;
  for (int i = 0; i < times; ++i)
    text += line;
  return text;
}

bool says(const Point_cloud& cloud, const std::string& warning)
{
  return cloud.warnings.size() == 1 && cloud.warnings.front().find(warning) != std::string::npos;
}

// Vectors of a text are normals if nearly all of them have unit length.
void test_vectors_of_xyz()
{
  const std::string unit = "1 2 3 0 .6 -.8\n", nearly = "1 2 3 .58 .58 .58\n",
                    zero = "1 2 3 0 0 0\n";
  const std::string short_one = "1 2 3 0 0 .98\n", color = "1 2 3 200 100 0\n",
                    none = "1 2 3 nan 0 1\n";
  const auto are_normals = [&](const std::string& text) {
    const Point_cloud cloud = read(".xyz", text, with_normals());
    const bool are = !cloud.normals.empty();
    CHECK(cloud.normals.size() == (are ? cloud.points.size() : 0));
    const bool are_all_kept = are && text.find(color) == std::string::npos; // as they are
    CHECK(cloud.warnings.size() == (are_all_kept ? 0 : 1));
    CHECK(are || cloud.warnings.front().find("--columns") != std::string::npos);
    return are;
  };
  CHECK(are_normals(repeated(19, unit) + color));
  CHECK(are_normals(repeated(18, nearly) + repeated(100, zero) + unit + none));
  CHECK(!are_normals(repeated(18, unit) + color));
  CHECK(!are_normals(repeated(18, unit) + short_one));
  CHECK(!are_normals(zero) && !are_normals(none) && !are_normals(none + color));
  // A point may have none, as PCL writes it with NaN, and then a note says how many there are
  CHECK(are_normals(unit + repeated(30, none)));
  const Point_cloud some = read(".xyz", unit + repeated(3, none), with_everything());
  CHECK(some.normals[0] == Vector(0, .6, -.8) && std::isnan(some.normals[3].x()));
  CHECK(some.notes.size() == 1
        && some.notes[0].find("3 points have no normal") != std::string::npos);

  Read_options options = with_normals();
  options.columns = {"x", "y", "z", "nx", "ny", "nz"};
  const Point_cloud named = read(".xyz", repeated(2, "1 2 3 300 -400 0\n") + nearly + zero,
                                 options);
  CHECK(named.normals
        == (std::vector<Vector>{Vector(.6, -.8, 0), Vector(.6, -.8, 0), Vector(.58, .58, .58),
                                Vector(0, 0, 0)}));
  CHECK(says(named, "2 normals are no unit vectors, and are scaled to length 1"));
}

// Colors of 0 and 1 have unit length too, if they are red, green and blue.
void test_colors_of_unit_length()
{
  const auto rows = [](const std::vector<std::string>& vectors, int number, double height) {
    std::string text;
    for (int i = 0; i < number; ++i)
      text += std::to_string(i % 4) + " " + std::to_string(i / 4) + " "
              + std::to_string(height * (i % 3)) + " " + vectors[std::size_t(i) % vectors.size()]
              + "\n";
    return text;
  };
  const auto have_normals = [](const std::string& text, const Read_options& options) {
    const Point_cloud cloud = read(".xyz", text, options);
    CHECK(cloud.file_has_normals == !cloud.normals.empty());
    CHECK(cloud.file_has_normals
            ? cloud.warnings.empty()
            : says(cloud, "columns 4 to 6 are 1 0 0, 0 1 0 or 0 0 1 alone, as colors may be, and "
                          "not taken for normals"));
    return cloud.file_has_normals;
  };
  const std::vector<std::string> palette = {"1 0 0", "0 0 1", "0 0 0"};
  const Read_options options = with_normals();
  CHECK(!have_normals(rows(palette, 40, 1), options)
        && !have_normals(rows(palette, 40, 0), options));
  CHECK(have_normals(rows(palette, 9, 1), options));
  CHECK(says(read(".xyz", rows({"1 0 0", "0 0 1", "1 1 0"}, 40, 1), options),
             "columns 4 to 6 are no unit vectors"));
  CHECK(have_normals(rows({"1 0 0", "0 0 -1"}, 40, 1), options));
  CHECK(have_normals(rows({"1 0 0", "0 0 1", ".6 0 .8"}, 40, 1), options));
  CHECK(have_normals("# x y z nx ny nz\n" + rows(palette, 40, 1), options));
  Read_options with_names = options;
  with_names.columns = {"x", "y", "z", "nx", "ny", "nz"};
  CHECK(have_normals(rows(palette, 40, 1), with_names));
  // All of one of them are normals of a plane, and of nothing else
  CHECK(have_normals(rows({"0 0 1"}, 40, 0), options));
  CHECK(have_normals(rows({"0 0 1"}, 40, 0.1), options));
  CHECK(!have_normals(rows({"0 0 1"}, 40, 1), options));
  CHECK(!have_normals(rows({"1 0 0"}, 40, 0), options));
}

// Of the few vectors that are not, too.
void test_scaled_normals()
{
  const Point_cloud xyz = read(".xyz", repeated(19, "1 2 3 0 .6 -.8\n") + "1 2 3 0 3 0\n",
                               with_normals());
  CHECK(xyz.normals.front() == Vector(0, .6, -.8) && xyz.normals.back() == Vector(0, 1, 0));
  CHECK(says(xyz, "1 normals are no unit vectors, and are scaled to length 1"));
  const Point_cloud obj =
    read(".obj", repeated(20, "v 1 2 3\n") + repeated(19, "vn 0 .6 -.8\n") + "vn 0 0 -1e200\n",
         with_normals());
  CHECK(obj.normals.front() == Vector(0, .6, -.8) && obj.normals.back() == Vector(0, 0, -1));
  CHECK(says(obj, "1 normals are no unit vectors, and are scaled to length 1"));
}

void test_csv()
{
  const Read_options everything = with_everything();
  const std::vector<Point> two = {Point(1, 2, 3), Point(-10, .5, 4)};
  const auto names_of = [](const Point_cloud& cloud) {
    std::string names;
    for (const Property& property : cloud.properties.properties())
      names += property.name + " ";
    return names;
  };
  const auto value = [](const Point_cloud& cloud, std::size_t i, std::size_t property) {
    return cloud.properties.value(i, cloud.properties.properties()[property]);
  };

  // Separators, quotes, blanks, an order of columns, lines that are empty or comments
  for (const char* text :
       {"x,y,z\n1,2,3\n-1e1,+.5,4\n", "# made by a program\n# X;Y;Z\n\n1; 2;3\n# half\n-10;0.5;4",
        "//X\tY\tZ\r\n1\t2\t3\r\n-10\t.5\t4\r\n", "x  y z\n 1 2  3 \n-10 .5 4\n",
        "\xef\xbb\xbf\"z\", \"x\" ,y\n\"3\",1,2\n4,\"-10\",0.5\n",
        "Points:0,Points:1,Points:2\n1,2,3\n-10,.5,4\n"})
  {
    CHECK(read(".csv", text).points == two);
    CHECK(read(".CSV", text, everything).warnings.empty());
  }

  // Normals, a color, a missing value, an empty name, a text and a name that is there twice
  const std::string table =
    "X,Normal_X,Normal_Y,Normal_Z,Y,Z,R,G,B,\"Scalar \"\"f\"\"\",class,,n,n\n"
    "1,0,0,1,2,3,255,0,7,0.5,\"a, b\",8,4,5\n"
    "-10,0,1,0,.5,4,1,2,3,,c,8,6,7\n";
  const Point_cloud cloud = read(".csv", table, everything);
  CHECK(cloud.points == two);
  CHECK(cloud.normals == (std::vector<Vector>{Vector(0, 0, 1), Vector(0, 1, 0)}));
  CHECK(names_of(cloud) == "red green blue Scalar___f__ n ");
  CHECK(cloud.properties.properties()[0].type == Number_type::UINT8 && value(cloud, 0, 0) == 255);
  CHECK(value(cloud, 0, 3) == .5 && std::isnan(value(cloud, 1, 3)) && value(cloud, 1, 4) == 6);
  CHECK(cloud.warnings.size() == 2);
  CHECK(cloud.warnings[0].find("'n' is left out: another one has that name") != std::string::npos);
  CHECK(cloud.warnings[1].find("'class' is left out: 'a, b' is not a") != std::string::npos);
  CHECK(read(".csv", table).warnings.empty());
  const Point_cloud no_color = read(".csv", "x,y,z,r,nx\n1,2,3,4,5\n", everything);
  CHECK(names_of(no_color) == "r " && no_color.normals.empty() && no_color.warnings.size() == 1);
  CHECK(read(".csv", "x,y,z\n").points.empty());

  Read_options options;
  options.drop_non_finite = true;
  CHECK(read(".csv", "x,y,z\n1,2,3\n4,,6\n-10,.5,4\n", options).points == two);
  CHECK(read(".csv", "x,y,z\n1,2,3\n4,,6\n-10,.5,4\n", options).number_of_dropped_points == 1);

  // Names from the command line, with a header or without
  options = {};
  options.columns = {"z", "-", "y", "x"};
  const std::string rows = "3;a;2;1\n4;b;.5;-10\n";
  CHECK(read(".csv", rows, options).points == two);
  CHECK(read(".csv", "# x;y;z;w\n" + rows, options).points == two);
  CHECK(read(".csv", "height;id;north;east\n" + rows, options).points == two);
}

// Named vectors too are normals only if they have unit length, unless the caller names them.
void test_named_vectors()
{
  const std::string table = "x,y,z,nx,ny,nz\n1,2,3,0,200,100\n4,5,6,10,20,30\n";
  const Point_cloud cloud = read(".csv", table, with_everything());
  CHECK(cloud.normals.empty() && !cloud.file_has_normals && cloud.warnings.size() == 1);
  CHECK(cloud.warnings[0].find("the normals are left out, as they are no unit vectors")
        != std::string::npos);
  Read_options options = with_everything();
  options.columns = {"x", "y", "z", "nx", "ny", "nz"};
  CHECK(read(".csv", table, options).normals.size() == 2);
  CHECK(read(".obj", "v 1 2 3\nvn 0 0 2\n", with_normals()).normals.empty());
  CHECK(read(".off", "NOFF\n1 0 0\n1 2 3 4 5 6\n", with_normals()).normals.empty());
}

// Lines that name columns, with the number of points or without, in all kinds of texts
void test_headers_of_texts()
{
  const std::vector<Point> two = {Point(1, 2, 3), Point(-10, .5, 4)};
  const auto names_of = [](const Point_cloud& cloud) {
    std::string names;
    for (const Property& property : cloud.properties.properties())
      names += property.name + " ";
    return names;
  };
  for (const char* extension : {".xyz", ".txt", ".asc", ".pts", ".csv"})
    for (const char* header :
         {"//X Y Z R G B\n", "//X Y Z R G B\n2\n", "2\n//X Y Z R G B\n", "# x y z r g b\n",
          "x y z Red GREEN blue\n", "# x y z of a scanner\n# X Y Z Red Green Blue\n# units: m\n"})
    {
      const Point_cloud cloud =
        read(extension, header + std::string("1 2 3 255 0 7\n-10 .5 4 1 2 3\n"), with_everything());
      CHECK(cloud.points == two && cloud.warnings.empty());
      CHECK(names_of(cloud) == "red green blue ");
    }
  CHECK(read(".xyz", "# x y z of a scanner\n1 2 3\n-10 .5 4\n").points == two); // no header
  CHECK(read(".txt", "X;Y;Z\n1;2;3\n-10;.5;4\n").points == two);
  CHECK(read(".txt", "v x y z\n7 1 2 3\n7 -10 .5 4\n").points == two); // no OBJ
  CHECK(read(".txt", "1, 2, 3\n-10, .5, 4\n").points == two);
  CHECK(read(".xyz", "//X Y Z Nx Ny Nz\n1 2 3 0 0 1\n", with_normals()).normals.size() == 1);
  // A trajectory, and scalar fields beside coordinates and normals of the same names
  CHECK(
    names_of(read(".txt", "# timestamp tx ty tz qx\n9 1 2 3 0\n9 -10 .5 4 0\n", with_everything()))
    == "timestamp qx ");
  const Point_cloud fields =
    read(".txt",
         "//X Y Z scalar_X scalar_R scalar_G scalar_B scalar_Scalar_field\n"
         "1 2 3 9 255 0 7 .5\n-10 .5 4 9 1 2 3 .5\n",
         with_everything());
  CHECK(fields.points == two && fields.warnings.empty());
  CHECK(names_of(fields) == "scalar_X red green blue scalar_Scalar_field ");
  Read_options ground = with_everything();
  ground.classes = {2};
  for (const char* name : {"Classification", "scalar_Classification", "classification"})
    CHECK(read(".csv", std::string("X,Y,Z,") + name + "\n1,2,3,2\n-10,.5,4,5\n", ground).points
          == std::vector<Point>{two[0]});
  // A column that numbers the points, unless it has a name or there is nothing else for x
  std::string numbered, first_is_x;
  for (int i = 0; i < 20; ++i)
  {
    numbered += std::to_string(i) + " 1.5 " + std::to_string(i) + " 3\n";
    first_is_x += std::to_string(i) + " 1.5 3\n";
  }
  CHECK(refusal(".xyz", numbered).says("the first column numbers the points"));
  CHECK(read(".xyz", "# id x y z\n" + numbered).points[4] == Point(1.5, 4, 3));
  CHECK(read(".xyz", first_is_x).points[4] == Point(4, 1.5, 3));
  // A separator behind the last cell, which is an empty cell where a column has the name
  for (const char* text : {"1;2;3;\n-10;.5;4;\n", "x,y,z\n1,2,3,\n-10,.5,4,\n"})
  {
    const Point_cloud cloud = read(".txt", text, with_everything());
    CHECK(cloud.points == two && cloud.warnings.empty());
  }
  const Point_cloud missing = read(".csv", "x,y,z,h\n1,2,3,\n-10,.5,4,7\n", with_everything());
  CHECK(missing.points == two
        && std::isnan(missing.properties.value(0, missing.properties.properties()[0])));
  CHECK(refusal(".txt", "east north depth\n1 2 3\n").says("--columns can name them"));
  // Whole numbers that double has no room for
  const auto ids = [](const char* id) {
    return read(".csv", std::string("x,y,z,id\n1,2,3,") + id + "\n-10,.5,4,1\n", with_everything())
      .warnings.size();
  };
  CHECK(ids("9007199254740992") == 0 && ids("9007199254740994") == 1 && ids("0.5") == 0);
  // Units, words of surveyors, the mark of a comment in MATLAB, and the first line of a spreadsheet
  for (const char* header :
       {"X [m],Y [m],Z [m]\n", "x(mm),y(mm),z(mm)\n", "X_m,Y_m,Z_m\n", "Easting,Northing,Height\n",
        "east,north,elevation\n", "East,North,Up\n", "pX,pY,pZ\n",
        "cartesianX,cartesianY,cartesianZ\n", "% x,y,z\n", "% by hand\n", "Easting,Northing,Elev\n",
        "#tx,ty,tz\n", "sep=,\nX,Y,Z\n", "\xef\xbb\xbfSep=,\r\nX,Y,Z\r\n"})
  {
    const Point_cloud cloud = read(".txt", header + std::string("1,2,3\n-10,.5,4\n"),
                                   with_everything());
    CHECK(cloud.points == two && cloud.warnings.empty());
  }
  // Other comments, and counts with a name
  for (const char* begin : {"Number of points: 2\n", "Points:2\n", "! by a scanner\n",
                            "; by a scanner\n2\n", "! x y z\n", "; x y z\n! half\n"})
    CHECK(read(".txt", begin + std::string("1 2 3\n! middle\n-10 .5 4\n")).points == two);
  CHECK(refusal(".txt", "Number of points: 3\n1.000000 2.000000 3.000000\n")
          .says("after 1 points, its first line"));
  CHECK(
    refusal(".txt", "Points of a wall\n1 2 3\n")
      .says("'Points' is not a number, and no line names columns x, y and z; --columns can name "
            "them; a line that is no point has to begin with #"));
  CHECK(read(".txt", "# Points of a wall\n1 2 3\n-10 .5 4\n").points == two);
  CHECK(read(".csv", ";x;y;z\na;1;2;3\n;-10;.5;4\n").points == two); // cells that are empty
  // The names of points before their coordinates
  for (const char* rows :
       {"P1 1 2 3\nP2 -10 .5 4\n", "P1,1,2,3\nP2,-10,.5,4\n", "\"P 1\";1;2;3\n\"P 2\";-10;.5;4\n"})
  {
    const Point_cloud cloud = read(".txt", rows, with_everything());
    CHECK(cloud.points == two && cloud.warnings.empty() && cloud.notes.size() == 1);
  }
  CHECK(read(".txt", "P1 1 2 3 9\nP2 -10 .5 4 9\n", with_everything()).warnings.size() == 1);
  CHECK(refusal(".txt", "P1 Q 2 3\n").says("'P1' is not a number"));
  CHECK(refusal(".csv", "1,2,3\n").says("--input-format xyz"));

  Read_options options = with_everything();
  options.columns = {"z", "-", "y", "x"};
  CHECK(read(".txt", "height id north east\n3 1 2 1\n4 2 .5 -10\n", options).points == two);
  CHECK(read(".txt", "Number of points: 2\n3 1 2 1\n4 2 .5 -10\n", options).points == two);
  CHECK(refusal(".txt", "Points of walls\n3 1 2 1\n", options)
          .says("--columns names 4, found 3; a line that is no point has to begin with #"));
}

// Names are separated as rows are not, as numpy.savetxt() writes them. No order stands in for them.
void test_names_over_other_separators()
{
  const std::vector<Point> two = {Point(1, 2, 3), Point(-10, .5, 4)};
  for (const char* text : {"# r, g, b, x, y, z\n255 0 7 1 2 3\n1 2 3 -10 .5 4\n",
                           "# y, x, z, r, g, b\n2 1 3 255 0 7\n.5 -10 4 1 2 3\n",
                           "//Y X Z R G B\n2,1,3,255,0,7\n.5,-10,4,1,2,3\n",
                           "//X Y Z R G B\n1\t2\t3\t255\t0\t7\n-10\t.5\t4\t1\t2\t3\n",
                           "x, y, z, r, g, b\n1 2 3 255 0 7\n-10 .5 4 1 2 3\n",
                           "z;y;x;r;g;b\n3 2 1 255 0 7\n4 .5 -10 1 2 3\n",
                           "x y z r g b\n1,2,3,255,0,7\n-10,.5,4,1,2,3\n"})
    for (const char* extension : {".txt", ".csv"})
    {
      const Point_cloud cloud = read(extension, text, with_everything());
      CHECK(cloud.points == two && cloud.normals.empty() && cloud.warnings.empty());
      CHECK(cloud.properties.properties().size() == 3
            && cloud.properties.properties()[0].name == "red"
            && cloud.properties.value(0, cloud.properties.properties()[0]) == 255);
    }
  const Point_cloud unnamed = read(".txt", "# y, x, z, red\n1 2 3\n-10 .5 4\n");
  CHECK(unnamed.points == two && unnamed.warnings.size() == 1
        && unnamed.warnings[0].find("names 4 columns") != std::string::npos);
}

// Colors of texts are bytes, or numbers of 16 bits, as LAS and PLY have them.
void test_types_of_colors()
{
  const auto type_of = [](const std::string& color) {
    const Point_cloud cloud =
      read(".csv", "x,y,z,red,green,blue\n1,2,3,0,0,255\n-10,.5,4,0,0," + color + "\n",
           with_everything());
    CHECK(cloud.properties.properties()[0].type == cloud.properties.properties()[2].type);
    return cloud.properties.properties()[2].type;
  };
  CHECK(type_of("255") == Number_type::UINT8 && type_of("256") == Number_type::UINT16);
  CHECK(type_of("65535") == Number_type::UINT16 && type_of("65536") == Number_type::FLOAT64);
  CHECK(type_of("0.5") == Number_type::FLOAT64);
}

// Ends of lines, encodings and words for what is not there
void test_texts_of_other_systems()
{
  const std::vector<Point> two = {Point(1, 2, 3), Point(-10, .5, 4)};
  for (const char* text : {"1 2 3\r-10 .5 4\r", "1 2 3\r-10 .5 4", "x,y,z\r1,2,3\r-10,.5,4\r",
                           "2\r\n1 2 3\r\n-10 .5 4\r\n", "# a\n1 2 3\r\r\n-10 .5 4\r\n"})
    CHECK(read(".txt", text).points == two);
  // More lines than the buffer of a file holds
  CHECK(read(".xyz",
             [] {
               std::string text;
               for (int i = 0; i < 40000; ++i)
                 text += std::to_string(i) + " 2 3\r";
               return text;
             }())
          .points.size()
        == 40000);
  using namespace std::string_literals;
  for (const std::string& utf16 :
       {"\xff\xfe"s + "1\0 \0002\0 \0003\0\n\0"s, "\xfe\xff"s + "\0001\0 \0002\0 \0003\0\n"s})
    CHECK(refusal(".txt", utf16).says("UTF-16"));

  for (const char* nothing : {"", "NA", "N/A", "null", "None", "nan", "-nan", "-1.#IND", "1.#QNAN"})
  {
    const Point_cloud cloud =
      read(".csv", "x,y,z,h,k\n1,2,3," + std::string(nothing) + ",7\n-10,.5,4,8," + nothing + "\n",
           with_everything());
    CHECK(cloud.points == two && cloud.warnings.empty());
    CHECK(cloud.properties.properties().size() == 2);
    CHECK(std::isnan(cloud.properties.value(0, cloud.properties.properties()[0])));
    CHECK(std::isnan(cloud.properties.value(1, cloud.properties.properties()[1])));
  }
  CHECK(refusal(".csv", "x,y,z\n1,2,NA\n").says("--drop-non-finite"));

  // Nearer to 0 than any number of double precision
  const std::string zeros(400, '0');
  for (const std::string& tiny : {"1e-400"s, "-2.5E-999"s, "0." + zeros + "1", "-." + zeros + "1"})
    CHECK(read(".xyz", tiny + " 2 3\n").points == std::vector<Point>{Point(0, 2, 3)});
  for (const std::string& huge : {"1e400"s, "1" + zeros, "-1" + zeros + ".5"})
    CHECK(refusal(".xyz", huge + " 2 3\n").says("is not a number"));
}

void test_blocks_of_pts()
{
  const std::vector<Point> three = {Point(1, 2, 3), Point(4, 5, 6), Point(7, 8, 9)};
  const Point_cloud cloud = read(".pts", "2\n1 2 3 9\n4 5 6 9\n\n1\n7 8 9 9\n0\n");
  CHECK(cloud.points == three && cloud.warnings.empty());
  CHECK(read(".pts", "1\n1 2 3\n4 5 6\n1\n7 8 9\n").warnings.size() == 1);
  CHECK(refusal(".pts", "2\n1 2 3\n1\n4 5 6\n7 8 9\n").says("3 columns expected"));
  CHECK(refusal(".pts", "1\n1 2 3\n2\n4.5 5.5 6.5\n").says("after 1 points"));
  CHECK(refusal(".pts", "1\n1 2 3\n999\n4 5 6\n").says("999 points are announced"));

  const Point_cloud named = read(".pts", "2\nX Y Z\n1 2 3\n4 5 6\n1\nX Y Z\n7 8 9\n");
  CHECK(named.points == three && named.warnings.empty());

  // Empty blocks, wherever they are
  const std::string rows = "1 2 3\n4 5 6\n7 8 9\n";
  for (const std::string& text : {"0\n3\n" + rows, "0\n0\n3\n" + rows,
                                  "# none\n0\n\nx y z\n3\n" + rows, "Points: 0\nPoints: 3\n" + rows,
                                  "3\n" + rows + "0\n", "1\n1 2 3\n0\n0\n2\n" + rows.substr(6)})
  {
    const Point_cloud blocks = read(".pts", text);
    CHECK(blocks.points == three && blocks.warnings.empty());
  }
  CHECK(read(".pts", "0\n0\n").points.empty() && read(".pts", "0\n" + rows).points == three);
  CHECK(
    refusal(".pts", "0\n2\n1.25 2.25 3.25\n").says("after 1 points, its first line announced 2"));
  CHECK(refusal(".pts", "0\n999\n1 2 3\n").says("999 points are announced"));
  CHECK(refusal(".pts", "2\n3\n" + rows).says("a point needs 3 numbers, found 1"));
  CHECK(read(".pts", "0\n1\n1 2 3\n0 0 1\n", with_normals()).normals.size() == 1);
}

// The number of points, all points, then all normals, as some files .pwn have them.
void test_normals_behind_points()
{
  const std::vector<Point> points = {Point(1, 2, 3), Point(7, 8, 9)};
  const std::vector<Vector> normals = {Vector(0, 0, -1), Vector(0.6, 0.8, 0)};
  const std::string begin = "2\n1 2 3\n7 8 9\n", rest = "0 0 -1\n.6 .8 0\n";
  for (const char* extension : {".pwn", ".xyz"})
  {
    const Point_cloud cloud = read(extension, begin + rest, with_everything());
    CHECK(cloud.points == points && cloud.normals == normals && cloud.file_has_normals);
    CHECK(cloud.warnings.empty());
  }
  CHECK(read(".pwn", begin + rest).points == points);
  Read_options options = with_normals();
  options.drop_non_finite = true;
  const Point_cloud dropped = read(".pwn", "3\nnan 0 0\n1 2 3\n7 8 9\n1 0 0\n" + rest, options);
  CHECK(dropped.points == points && dropped.normals == normals);
  CHECK(read(".pwn", begin + "0 0 0\n.6 .8 0\n", with_normals()).normals[1] == normals[1]);

  // Else further points, as far as there are some: of another length, less, more, another block
  const std::string message = "more points than the 2, which the first line announced";
  for (const std::string& more : {std::string("0 0 -1\n.6 .7 0\n"), std::string("0 0 -1\n"),
                                  rest + "1 0 0\n", std::string("0 0 0\n0 0 0\n")})
  {
    const Point_cloud cloud = read(".pwn", begin + more, with_everything());
    CHECK(cloud.points.size() == 2 + std::size_t(std::count(more.begin(), more.end(), '\n'))
          && cloud.points[1] == points[1] && !cloud.file_has_normals);
    CHECK(cloud.warnings.size() == 1 && cloud.warnings[0].find(message) != std::string::npos);
  }
  const Point_cloud blocks = read(".pwn", begin + rest + "1\n4 5 6\n", with_everything());
  CHECK(blocks.points.size() == 5 && blocks.points[2] == Point(0, 0, -1)
        && blocks.points[4] == Point(4, 5, 6) && !blocks.file_has_normals);
  CHECK(read(".xyz", "1 2 3\n7 8 9\n" + rest, with_normals()).points.size() == 4);

  // What waits for the last row is not without a limit
  Read_options narrow = with_normals();
  narrow.max_memory = 2 * (sizeof(Point) + sizeof(Vector));
  CHECK(read(".pwn", begin + rest, narrow).normals.size() == 2);
  narrow.max_memory = 2 * sizeof(Point) + sizeof(Vector);
  CHECK(refusal(".pwn", begin + rest, narrow).status == RUN_TIME_FAILURE);
  // and does not count any more once it has become points
  const std::size_t count = 8;
  std::string many = begin;
  for (std::size_t i = 2; i < count; ++i)
    many += "0 0 1\n";
  narrow.max_memory = count * sizeof(Point);
  CHECK(read(".pwn", many, narrow).points.size() == count);
  --narrow.max_memory;
  CHECK(refusal(".pwn", many, narrow).status == RUN_TIME_FAILURE);
}

void test_decimal_commas()
{
  Read_options options = with_everything();
  options.has_decimal_commas = true;
  const std::vector<Point> two = {Point(1.5, 2, -.25), Point(4, 5e-3, 6)};
  for (const char* text :
       {"1,5 2 -,25\n4,0 5e-3 6\n", "1,5;2;-0,25\n4;0,005;6\n", "1,5\t2\t-0,25\n4\t0,005\t6\n",
        "X;Y;Z\n1,5;2;-0,25\n4;0,005;6\n", "x y z\n1.5 2 -0.25\n4 0.005 6\n",
        "\"1,5\",\"2\",\"-0,25\"\n\"4\",\"0,005\",\"6\"\n",
        "x,y,z\n\"1,5\",\"2\",\"-0,25\"\n\"4\",\"0,005\",\"6\"\n"})
    CHECK(read(".txt", text, options).points == two);
  const Point_cloud cloud = read(".csv", "x;y;z;height;class\n1,5;2;-0,25;0,5;2\n4;0,005;6;1;3\n",
                                 options);
  CHECK(cloud.points == two);
  CHECK(cloud.properties.value(0, cloud.properties.properties()[0]) == .5);
  CHECK(cloud.properties.properties()[1].type == Number_type::INT32);
  CHECK(refusal(".txt", "1.234,5 2 3\n", options).says("'1.234,5' is not a number"));
  for (const char* text : {"1,5 2,5 3,5\n", "1,5;2,5;3,5\n", "1 2 3\n1 2 0,5\n", "1,5 2 3\n"})
    CHECK(refusal(".txt", text).says("--decimal-comma"));
  CHECK(!refusal(".txt", "1 2 x\n").says("--decimal-comma"));

  // Where the columns have no names and more are needed, as those of viewpoints
  options.needs_names_of_rest = true;
  const std::string places = "2,0 1,5 1,2\n6,0 1,5 1,3\n";
  CHECK(read(".txt", places, options).points.size() == 2);
  options.has_decimal_commas = false;
  const std::string not_told = "which of the columns are x, y and z is not told";
  const Failure_seen seen = refusal(".txt", places, options);
  CHECK(seen.says(not_told) && seen.says("--decimal-comma reads numbers such as 0,5"));
  const Failure_seen unnamed = refusal(".txt", "1 2 3 4\n", options);
  CHECK(unnamed.says(not_told) && !unnamed.says("--decimal-comma"));
}

} // namespace

int main()
{
  test_xyz();
  test_vectors_of_xyz();
  test_colors_of_unit_length();
  test_scaled_normals();
  test_csv();
  test_named_vectors();
  test_headers_of_texts();
  test_names_over_other_separators();
  test_types_of_colors();
  test_texts_of_other_systems();
  test_blocks_of_pts();
  test_normals_behind_points();
  test_decimal_commas();
  return test::result();
}
