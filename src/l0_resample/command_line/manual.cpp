// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/manual.h"

#include "command_line/command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

constexpr const char* summary =
  "turns noisy points into clean, evenly spread, oriented ones that keep sharp features";

constexpr std::array<const char*, 2> usages = {
  "l0_resample [OPTIONS] INPUT OUTPUT", "l0_resample [OPTIONS] INPUT... --output-directory FOLDER"};

constexpr std::array<const char*, 3> examples = {
  "l0_resample scan.ply clean.ply --percentage 50 --snapshot picture.png",
  "l0_resample scans/*.pcd --output-directory clean --output-format ply -n 100000",
  "l0_resample --convert-only table.csv.gz scan.ply"};

struct Section
{
  const char* title;
  const char* text; ///< paragraphs, with an empty line between them
};

constexpr std::array<Section, 12> sections = {
  {{"FILES",
    R"(PLY and PCD (ASCII, binary and compressed), LAS, OFF, XYZ, NPY, CSV and OBJ are read. PLY
and PCD (binary), LAS, OFF, XYZ and NPY are written with normals, as a whole or not at all. What
gzip has compressed (.ply.gz, ...) is read as what it stands for. LAZ is read through a command, as
in --decompress 'laszip -i {} -olas -stdout': it is started by the shell for each file whose name
or content is that of LAZ, and what it writes is read as LAS. PCD is written with the VIEWPOINT of
the call: that of --viewpoint or of INPUT, else 0,0,0. A name that begins with a dash goes behind
--.

A file is not replaced without --force: if OUTPUT exists, also if it is INPUT, or a result of a
batch, nothing is done. Reports (--json), pictures (--snapshot) and pages (--page) of an earlier run
are replaced. INPUT - is standard input; OUTPUT - and --json - are standard output. That, a pipe,
and what leads to a descriptor, such as /dev/stdout, /dev/fd/3 or /proc/self/fd/3, is written to as
it is open, also if it is redirected to a file.

XYZ, a text (.xyz, .xyzn, .pwn, .pts, .txt, .asc), may name its columns before the points; else it
has coordinates in its first three columns and, if it has six, normals in the others. --columns
tells what the columns of a text, or of an array (NPY), are: x, y, z, nx, ny, nz, red, green, blue,
alpha as in PLY, any other name for a property of the points, - or _ for a column to leave out. CSV,
a table, names its columns in its first line. Names are those of all formats, such as X, NormalX or
R. Of OBJ, vertices (v) are read, and normals (vn) as faces name them; without faces, if there are
as many. Where normals of any format are no unit vectors, they are left out, and a warning says so;
a few, and those that --columns names, are scaled to length 1, and it says how many.
Properties whose values are all whole numbers may be labels, and are not averaged.

LAS 1.0 to 1.4 is read with the fields of its points and with its extra bytes, but without waveforms
and points that are flagged as withheld. --keep-classes and --first-returns look at the properties
classification and return_number, which points of other formats may have too. LAS is written with
scales that move no point by more than a thousandth of the spacing, as version 1.4, or 1.2 if the
points of INPUT are of formats 0 to 5. From LAS to LAS the coordinate system goes along. If x and y
are degrees, as the records of the file or its coordinates tell, they are no lengths as heights are,
and the file is refused: project it first, as with filters.reprojection of PDAL, or give
--allow-degrees.)"},
   {"METHODS",
    R"(LOR and ALOR are the methods of the paper, the default method is the one that is
recommended. The radius of a neighborhood follows from spacing and noise of the points in the
default method, and is the diagonal per cube root of the number of points in LOR and ALOR.

The default method flattens no jump that is too large for noise. So there is a limit of
--normal-weight, which grows with the noise, from which on larger values give the same result; a
note says so.)"},
   {"WITHOUT OUTPUT",
    R"(--info tells of one INPUT the number of points, the extent, whether it has normals, version,
point format and scale of LAS, whether x and y are degrees, which other properties its points have,
and the viewpoint of a PCD file, or the camera of PLY, unless that is 0,0,0, but for rounding, which
many programs write if they know none; then spacing and noise of the points as the default method
estimates them, and the radius and the number of points that a run with these options would have.

--dry-run does all but to resample and to write: it reads INPUT, finds the radius, and finds out
whether device, OUTPUT, report and picture could be used. The exit status is that of what is
found. A batch makes no folder.)"},
   {"CONVERSIONS",
    R"(--convert-only keeps the points as they are: PLY, PCD (binary) and LAS get all that INPUT
tells of each, OFF normals and colors, XYZ and NPY normals; warnings say what else INPUT had. LAS
rounds coordinates, but for those of another LAS. It takes no option on resampling.

--orient-only writes the same, with normals. Those of INPUT change at most their sign; where one is
zero or not finite, or INPUT has none, it is estimated. They point outwards, or as the options on
viewpoints, --up and --orient-by-normals say. Points are neither moved nor reordered. Of the
options on the method it takes --neighbor-radius, for estimated normals.)"},
   {"BATCHES",
    R"(With --output-directory all FILES, and those of folders, are resampled. Results go there,
under the same names; those of formats that are not written are PLY. Standard output gets one line
for each file that was resampled, and standard error, at the end, one for each that failed, also
one of no known format, and their number; the others are not harmed. The exit status is that of
the failures if they all have the same, else 1. After SIGINT, SIGTERM or --timeout no other file
is begun. A result never takes the place of an input, or of another result. --snapshot names a
folder, which gets NAME.png of each result NAME.)"},
   {"LARGE CLOUDS",
    R"(--as-one takes all FILES as parts of one cloud, of any size. It is cut into tiles, each of
which with the points around it, within --halo, takes no more than --memory. --output-directory gets
a file for each tile, and index.json, which tells of them; --output writes all points to one file
too. The number of points is that of --points or --percentage. Samples get the properties of the
points nearest to them in any of FILES, which all need the same ones; normals of the input are not
used. Normals face the viewpoint of FILES if all have the same one; if not, a warning says that none
is used. With --device cuda, tiles are as large as a CUDA device holds too, and are resampled there;
else on the processor.

Tiles give what one tile gives: with --halo 80 to the bit in all that was tried, with less but for
roundings near borders; but for the signs of normals, where --memory does not hold all samples at
once, with what their sides are found from. Where it holds all points, that takes less time.

Steps are kept in the folder work of the output directory until all is done. --resume goes on with
them after a crash, and makes again what is damaged; a run with another input, other options or
another build of the program is refused. A folder that has a run is refused without --resume, or
--force, which begins anew. So is one with other files of the names index.json or tile_N, without
--force, and one with another folder work. No result takes the place of an input.)"},
   {"CREASES",
    R"(--creases writes the lines along which two faces of the surface meet: as lines l of OBJ, with
corners as points p, as edges of PLY, or as polylines of DXF. Points of OUTPUT nearest to a line
are moved onto it, and those that are left beside it away from it; the property crease is 1 for
points on a line, 2 for corners, and else 0. It needs the default method, and no --keep-density.
With --as-one, lines go on from tile to tile.)"},
   {"OUTLIERS",
    R"(--outliers writes the points of INPUT that are left out as outliers, as they were read, with
their properties: a file of any format that the tool writes, by its extension, and of no points
where none is left out. With --as-one they have no properties; else it is for one file.)"},
   {"CONFIGURATION",
    R"(The file that --config names has lines such as "method = lor" or "force = true": the long
name of an option, and its value, or true or false for one that takes none. Lines that begin with
# are skipped. The command line goes before the file: what it says, and what cannot go with that,
is not taken from the file. --output, --help, --version and --config are not in files.)"},
   {"PICTURES",
    R"(--snapshot draws INPUT on the left and the result on the right, seen by one eye in one light,
as surfaces of discs. Without normals of INPUT, its discs are planes through points nearby. What is
turned away from the eye is blue: the inside of a surface, or a normal of the wrong sign. With
--feature-confidence the result is the redder the surer it is of an edge, and with --creases they
are black lines. --snapshot-colors normals colors points by the direction of their normals instead,
x as red, y as green, z as blue. Up is where --up says; else it is z if few planes hold most points
and stand on z, as buildings and rooms do, and y if they stand on y or if there are no such planes.
The eye is beside the viewpoint, or on the broad side, or where --view says; y of a camera at 0,0,0
that looks along z points down. Of what was seen from within, as a room, the sides that are turned
away from the eye are not drawn. --snapshot-views 2 adds a row from the other side: half a turn
around what points up. With 3 there is one from above too, and with 4 one from below: in both, what
is near to the first eye is at the bottom.

--page writes one file of HTML, which a browser shows without a network: INPUT and result side by
side as points that turn together, the points that were left out, in red, and the report. The result
has the color of its radius, side or feature confidence, or with the default method of noise and
deviations, which are computed for it; a histogram shows how these are spread. Of more points it
holds 150000, evenly chosen.)"},
   {"OUTPUT OF THE PROGRAM",
    R"(Standard output gets one line of summary; if points or a report go there, standard error
gets it. Notes, warnings and errors are lines on standard error.)"},
   {"EXIT STATUS",
    R"(0 good, 1 failed at run time (memory, time, solver, device), 2 wrong usage, 3 input
refused, 4 output not written, 5 not converged (with --strict), 6 not enough memory (with --as-one),
130 and 143 cancelled by SIGINT and SIGTERM.)"}}};

/// With a name, that is, and with a group: those without one are not for the command line of users.
std::vector<const CLI::Option*> options_of(const CLI::App& app)
{
  return app.get_options([](const CLI::Option* option) {
    return option->nonpositional() && !option->get_group().empty();
  });
}

/// In the order in which they begin.
std::vector<std::string> groups_of(const CLI::App& app)
{
  std::vector<std::string> groups;
  for (const CLI::Option* option : options_of(app))
    if (std::find(groups.begin(), groups.end(), option->get_group()) == groups.end())
      groups.push_back(option->get_group());
  return groups;
}

std::vector<const CLI::Option*> options_of_group(const CLI::App& app, const std::string& group)
{
  std::vector<const CLI::Option*> options = options_of(app);
  const auto is_other = [&](const CLI::Option* option) { return option->get_group() != group; };
  options.erase(std::remove_if(options.begin(), options.end(), is_other), options.end());
  return options;
}

bool has_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::vector<std::string> names_of(const CLI::Option& option)
{
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames())
    names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    names.push_back("--" + name);
  return names;
}

std::string description_of(const CLI::Option& option)
{
  const std::string standard = option.get_default_str();
  return option.get_description() + (standard.empty() ? "" : " [" + standard + "]");
}

std::string line_of(const CLI::Option& option)
{
  constexpr std::size_t column = 33;
  std::string line = option.get_snames().empty() ? "     " : " ";
  for (const std::string& name : names_of(option))
    line += (name == names_of(option).front() ? " " : ", ") + name;
  if (has_value(option))
    line += " " + option.get_type_name();
  line.resize((std::max)(column, line.size() + 1), ' ');
  return line + description_of(option) + "\n";
}

/// So that man(7) takes no character for a command or for a typographic sign.
std::string for_man(std::string_view text)
{
  std::string escaped;
  bool is_begin_of_line = true;
  for (const char c : text) {
    if (is_begin_of_line && (c == '.' || c == '\''))
      escaped += "\\&";
    if (c == '-')
      escaped += "\\-";
    else if (c == '\\')
      escaped += "\\e";
    else
      escaped += c;
    is_begin_of_line = c == '\n';
  }
  return escaped;
}

std::string paragraphs_for_man(std::string_view text)
{
  std::string paragraphs;
  while (!text.empty()) {
    const std::size_t end = (std::min)(text.find("\n\n"), text.size());
    paragraphs += ".PP\n" + for_man(text.substr(0, end)) + "\n";
    text.remove_prefix((std::min)(end + 2, text.size()));
  }
  return paragraphs;
}

std::string option_for_man(const CLI::Option& option)
{
  std::string entry = ".TP\n";
  for (const std::string& name : names_of(option))
    entry += (name == names_of(option).front() ? "" : ", ") + ("\\fB" + for_man(name)) + "\\fR";
  if (has_value(option))
    entry += " \\fI" + for_man(option.get_type_name()) + "\\fR";
  return entry + "\n" + for_man(description_of(option)) + "\n";
}

/// For Doxygen, which takes two dashes for a longer one unless a backslash is before them.
std::string for_html(std::string_view text)
{
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i)
    switch (text[i]) {
    case '&': escaped += "&amp;"; break;
    case '<': escaped += "&lt;"; break;
    case '>': escaped += "&gt;"; break;
    default:
      if (text.substr(i, 2) == "--")
        escaped += '\\';
      escaped += text[i];
    }
  return escaped;
}

std::string row_for_html(const CLI::Option& option)
{
  std::string names;
  for (const std::string& name : names_of(option))
    names += (names.empty() ? "" : ", ") + ("<code>" + for_html(name)) + "</code>";
  if (has_value(option))
    names += " <i>" + for_html(option.get_type_name()) + "</i>";
  return "<tr><td>" + names + "</td><td>" + for_html(option.get_description()) + "</td><td>"
         + for_html(option.get_default_str()) + "</td></tr>\n";
}

std::string joined(const std::vector<std::string>& words, const std::string& separator)
{
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : separator) + word;
  return text;
}

/// What bash completes the value of an option to.
std::string values_for_bash(const CLI::Option& option)
{
  const std::vector<std::string> choices = choices_of(option.get_single_name());
  const std::string type = option.get_type_name();
  if (!choices.empty())
    return "COMPREPLY=($(compgen -W '" + joined(choices, " ") + "' -- \"$current\"))";
  if (type == "FOLDER")
    return "compopt -o filenames; COMPREPLY=($(compgen -d -- \"$current\"))";
  if (type == "FILE" || type == "FILE.png" || type == "FILE.html" || type == "OUTPUT")
    return "compopt -o filenames; COMPREPLY=($(compgen -f -- \"$current\"))";
  return "COMPREPLY=()";
}

} // namespace

std::string help_text(const CLI::App& app)
{
  std::string text = std::string("l0_resample ") + summary + ".\n";
  for (const char* usage : usages)
    text += std::string("  ") + usage + "\n";
  for (const std::string& group : groups_of(app)) {
    text += "\n" + group + ":\n";
    for (const CLI::Option* option : options_of_group(app, group))
      text += line_of(*option);
  }
  text += "\nExamples:\n";
  for (const char* example : examples)
    text += std::string("  ") + example + "\n";
  return text + "The manual, man l0_resample, tells of files, batches and exit statuses.\n";
}

std::string man_page(const CLI::App& app)
{
  std::string page = ".TH L0_RESAMPLE 1 \"\" \"l0_resample " L0_RESAMPLE_VERSION "\"\n.SH NAME\n";
  page += "l0_resample \\- " + for_man(summary) + "\n.SH SYNOPSIS\n.nf\n";
  for (const char* usage : usages)
    page += for_man(usage) + "\n";
  page += ".fi\n.SH OPTIONS\n";
  for (const std::string& group : groups_of(app)) {
    page += ".SS " + group + "\n";
    for (const CLI::Option* option : options_of_group(app, group))
      page += option_for_man(*option);
  }
  for (const Section& section : sections)
    page += std::string(".SH ") + section.title + "\n" + paragraphs_for_man(section.text);
  page += ".SH EXAMPLES\n.nf\n";
  for (const char* example : examples)
    page += for_man(example) + "\n";
  return page + ".fi\n";
}

std::vector<std::pair<std::string, std::string>> option_tables(const CLI::App& app)
{
  std::vector<std::pair<std::string, std::string>> tables;
  for (const std::string& group : groups_of(app)) {
    std::string table = "<table class=\"l0Table\">\n<tr><th>option</th><th>what it does</th>"
                        "<th>default</th></tr>\n";
    for (const CLI::Option* option : options_of_group(app, group))
      table += row_for_html(*option);
    std::string name = CLI::detail::to_lower(group);
    std::replace(name.begin(), name.end(), ' ', '_');
    tables.emplace_back(name, table + "</table>\n");
  }
  return tables;
}

std::string bash_completion(const CLI::App& app)
{
  std::string script = "# bash completion for l0_resample, made of its table of options\n"
                       "_l0_resample()\n{\n"
                       "  local current=${COMP_WORDS[COMP_CWORD]}\n"
                       "  case ${COMP_WORDS[COMP_CWORD - 1]} in\n";
  std::vector<std::string> names;
  for (const CLI::Option* option : options_of(app)) {
    const std::vector<std::string> of_option = names_of(*option);
    names.insert(names.end(), of_option.begin(), of_option.end());
    if (has_value(*option))
      script += "    " + joined(of_option, " | ") + ") " + values_for_bash(*option)
                + "; return ;;\n";
  }
  return script + "  esac\n  if [[ $current == -* ]]; then\n    COMPREPLY=($(compgen -W '"
         + joined(names, " ")
         + "' -- \"$current\"))\n  else\n    compopt -o filenames\n"
           "    COMPREPLY=($(compgen -f -- \"$current\"))\n  fi\n}\n"
           "complete -F _l0_resample l0_resample\n";
}

} // namespace l0_tool
