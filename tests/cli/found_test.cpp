// What people had and reported to other projects, in tests/data/found: each is read, and what they
// asked is answered, or one line says why not. Lengths and angles were computed with NumPy and
// mpmath, by the definitions; what else is expected was reported.
#include "cli/workshop.hpp"

namespace found_test {

using namespace phrame;
using namespace phrame::test;

namespace {

struct Case {
  const char* from;     ///< where it was reported, or with which program it was made
  const char* command;  ///< "@" is the folder of the files
  int status;
  std::vector<const char*> parts = {};  ///< of what is printed
  const char* note = nullptr;           ///< of stderr; null where there is nothing
};

const std::vector<Case> cases{
    // Closed but for rounding: np.linspace with both ends, splprep(per=True).
    {"SciPy",
     "totals @closed-scipy.json",
     0,
     {"closed, with 2 corners", "holonomy", "writhe"},
     "a gap of at most 2.8e-16 closed"},
    {"NumPy",
     "info @closed-linspace.csv",
     0,
     {"path of 40 curves, closed"},
     "the last point is taken for the first one, rounded"},
    {"NumPy",
     "construct @closed-linspace.csv --closed",
     0,
     {"41 points, the last of them the first", "spline of 41 segments, closed"}},
    // Smooth nodes whose handles are rounded.
    {"Blender", "info @blender.json", 0, {"with 1 corner of 6.95e-08 radians"}},
    {"Inkscape",
     "info @inkscape.svg",
     0,
     {"path of 3 curves, open, with 2 corners"},
     "2 corners, the greatest of 5.61e-05 radians at t = 1"},
    {"Inkscape", "info @inkscape.svg --max-corner 1e-5", 2, {}, "has a corner of 5.61e-05 radians"},
    {"a well", "info @well.json", 0, {"length ∫ |r′|          1400.0000000000000"}},
    // Whose parameter? NURBS-Python 99, 107; three.js computeFrenetFrames; coordinax 952.
    {"geomdl",
     "check @geomdl.json @geomdl-frames.csv",
     1,
     {"between 1.25720e-4 and 1.25721e-4"},
     "geomdl-frames.csv: t is taken for"},
    {"geomdl", "frames @geomdl.json --by native --samples 2 --columns s", 0, {",1\n"}},
    {"three.js", "check @three-tube.json @three-t.csv", 1, {"between 0.00878763 and 0.00878764"}},
    {"three.js",
     "check @three-tube.json @three-u.csv",
     1,
     {"between 0.00878763 and 0.00878764"},
     "three-u.csv: t is taken for"},
    {"coordinax",
     "check @helix.json @helix-frames.csv",
     0,
     {"between 3.14640e-7 and 3.14641e-7"},
     "helix-frames.csv: t is taken for"},
    {"coordinax",
     "angle @quarter.json --by native --at 0.5",
     0,
     {"\n  1/2      0.63661977236758134 "}},
    // The whole turn that a frame drifts by: gpytoolbox 136, 181.
    {"gpytoolbox",
     "check @spiral.json @spiral-reference.csv",
     1,
     {"drift            −0.8960272892 radians", "turns by −11.3159"}},
    // Trajectories and matrices.
    {"evo",
     "check @flight.csv @flight.tum",
     1,
     {"40 frames, t from 0 to 39", "fail: f2"},
     "t is taken from the positions: the joints"},
    {"evo",
     "check @spiral.json @spiral.kitti",
     1,
     {"81 frames, t from 0 to 1"},
     "12 columns without names"},
    {"evo",
     "construct @flight.tum --tangent-axis x",
     0,
     {"orientations    met exactly"},
     "timestamp is taken for the parameters"},
    // Tables as programs write them.
    {"", "info @PX.csv", 0, {"length ∫ |r′|          33.0522"}, "Position X, Position Y"},
    {"", "info @arr.json", 0, {"33.0522"}},
    {"", "info @objs.json", 0, {"33.0522"}},
    {"", "info @posx.csv", 0, {"33.0522"}, "pos_x, pos_y, pos_z"},
    {"", "info @de.csv", 0, {"33.0522"}, "commas are decimal ones"},
    {"", "info @l.obj", 0, {"33.0522"}, "natural cubic spline"},
    {"", "info @units.csv", 0, {"33.0397861217"}, "in mm"},
    {"", "info @dup.csv", 2, {}, "line 4: the point (21/2, 9/4, 1) is that before it"},
    {"", "info @dup.csv --skip-invalid", 0, {"33.0522"}, "left out is 1 row"},
    {"", "info @nan.csv", 2, {}, "line 4, x: \"NaN\" is not a number"},
    {"", "info @nan.csv --skip-invalid", 0, {"33.0522"}, "left out is 1 row"},
    {"", "info @emptyrow.csv", 2, {}, "line 4, x: the field is empty"},
    {"", "info @emptyrow.csv --skip-invalid", 0, {"33.0522"}, "left out is 1 row"},
    {"", "info @p.gcode", 0, {"path of 3 curves, open, with 2 corners"}, "2 corners"},
    {"", "info @p.apt", 0, {"path of 2 curves, open, with 1 corner"}, "the axes of the tool"},
    {"", "construct @p.gcode", 0, {"data            4 points"}, "the ends of its 3 lines"},
    {"", "construct @p.apt", 0, {"data            3 points"}, "the ends of its 2 lines"},
    {"", "construct @l.obj", 0, {"data            4 points"}, "the ends of its 3 lines"},
    {"", "construct @semi.svg", 2, {}, "segment 1 is no line"},
    // three.js: a scene, a geometry of before r145, and 29478, in which there are no numbers.
    {"three.js", "info @three-scene.json", 0, {"path of 6 curves"}, "the curve is \"b\""},
    {"three.js", "info @three-buffer.json", 0, {"X₂                     4t − 2\n"}},
    {"three.js", "info @three-empty.json", 2, {}, "\"Curve\" is no curve of three.js"},
    {"Godot 118400", "info @../curve3d.tres", 0, {"path of 2 curves, open"}, "tilts are left out"},
    {"Godot 118400",
     "frames @../curve3d.tres --samples 3 --roll 0,0.5,0",
     0,
     {"2,12,3,20"},
     "tilts are left out"},
    // Polylines: CadQuery 39, FreeCAD 21119; three.js 10483, lines that begin and end at rest.
    {"CadQuery", "totals @poly.csv", 0, {"= 19 + √5·(5)"}, "1 corner, of 1.11 radians"},
    {"CadQuery", "sweep @poly.csv --profile circle:1 -o out.glb", 0, {"3 sections"}, "1 corner"},
    {"three.js", "info @tension0.json", 0, {"12.718347206234"}, "2 corners, the greatest of 1.68"},
    {"three.js",
     "sweep @tension0.json --profile circle:1/10 -o out.glb",
     0,
     {"4 sections"},
     "2 corners"},
    // A line and an arc: KittyCAD 8428, FreeCAD 29598. An arc by itself.
    {"KittyCAD", "info @kcad.svg", 0, {"25.707963267948966"}},
    {"FreeCAD", "info @semi.svg", 0, {"62.831853071795865"}},
    {"KittyCAD", "sweep @kcad.svg --profile circle:1 -o out.glb", 0, {"sections, within"}},
    {"KittyCAD", "sweep @kcad.svg --profile circle:1 --exact -o out.obj", 0, {"8 rational Bezier"}},
    {"FreeCAD", "sweep @semi.svg --profile circle:1 --exact -o out.obj", 0, {"8 rational Bezier"}},
    // kurbo 344: both handles of an end in one point.
    {"kurbo",
     "info @loop.svg",
     0,
     {"cusp, r′ = 0           t = 1", "171.75126414410"},
     "with --near"},
    {"kurbo",
     "sweep @loop.svg --profile circle:1/10 -o out.glb",
     0,
     {"sections, within"},
     "the body folds"},
    {"kurbo", "offset @loop.svg --distance 1", 0, {"1, to both sides"}, "--near 1e-1"},
    // Planar quintics with equal derivatives; the energy of SciPy 9897's data.
    {"",
     "construct @equal-derivatives.json --kind planar --solution 2",
     0,
     {"length          ≈ 1.43965716922"}},
    {"",
     "construct @equal-derivatives.json --kind planar --solution 3",
     0,
     {"length          ≈ 1.43965716922"}},
    {"SciPy", "construct @hermite.json --kind planar --solution 3", 0, {"9361.82\n"}},
    // DESC 1535: the curvature is 0 at p = 0 and π.
    {"DESC", "info @axis.json", 0, {"7.0631900898132"}},
    {"DESC", "totals @axis.json --helicity 0,0,1", 0, {"helicity\n    = 1\n"}},
    {"DESC",
     "frames @axis.json --frame frenet-signed --columns signed_curvature --at 0,1/4,1/2,3/4",
     0,
     {",0,0.6,-0.8,", ",0,-1,0,", ",0,0.6,0.8,", ",1.1111111111111112\n",
      ",-1.1111111111111112\n"}},
    // Speeds that are no rational functions: toppra 150, ArcWelder 33. v = 1 + time with the first.
    {"toppra",
     "interpolate @hermite.json --period 1 --feed 'sqrt(1 + 2*s)'",
     0,
     {",1.5,2.0119", ",2\n",
      "3,2.2551733970701675,1,4.7980769224966675,5,2,0,3.2551733970701675\n"}},
    {"toppra", "interpolate @hermite.json --period 1 --feed 'min(1, s)'", 3, {}, "at t = 0"},
    // suica 105, Cinemachine 997: radius and roll in the table.
    {"suica",
     "sweep @radius.csv --profile circle:1 --scale-column radius -o out.glb",
     0,
     {"sections, within"}},
    {"Cinemachine", "frames @radius.csv --samples 2 --roll-column radius", 0, {"\n3,0,4,-20,"}},
    // Coefficients that are no fractions: SymPy 28657, 8954, FriCAS 198, Sage 38593.
    {"SymPy", "integrate '1/(x^2 - pi)'", 2, {}, "\"pi\" is not a rational number"},
    {"FriCAS", "integrate '1/(x^8 - a^2)'", 2, {}, "a second variable, \"a\" beside \"x\""},
    {"Sage", "integrate '1/(x^2 + I)'", 2, {}, "a second variable, \"I\" beside \"x\""},
    {"SymPy 9270", "integrate '1/x^2' --from -1 --to inf", 3, {}, "pole at 0"},
};

}  // namespace

TEST_CASE("found: what people have is read and answered, or one line says why not") {
  const Workshop here;
  std::filesystem::create_symlink(test::root("/tests/data/found"), here.file("found"));
  for (const Case& one : cases) {
    std::string command = one.command;
    CAPTURE(command);
    for (auto at = command.find('@'); at != std::string::npos; at = command.find('@', at))
      command.replace(at, 1, "found/");
    const Run run = here.run(command);
    CAPTURE(run.out);
    CAPTURE(run.err);
    CHECK(run.status == one.status);
    for (const char* part : one.parts) CHECK(contains(run.out, part));
    if (one.note == nullptr)
      CHECK(run.err.empty());
    else
      CHECK(contains(run.err, one.note));
    if (one.status < 2) continue;
    CHECK(run.out.empty());
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  }
}

/// Integrals that computer-algebra systems got wrong or left, with values by mpmath.
TEST_CASE("found: integrals are right, to some twenty digits") {
  const Workshop here;
  std::string lines;
  std::vector<std::string> values;
  std::istringstream table(bytes_of(test::root("/tests/data/found/integrals.csv")));
  std::string from, to, integrand, value;
  while (std::getline(table, from, ',') && std::getline(table, to, ',') &&
         std::getline(table, integrand, ',') && std::getline(table, value)) {
    if (from == "from") continue;
    lines += Json{{"question", "integrate"},
                  {"expr", integrand},
                  {"from", from},
                  {"to", to},
                  {"digits", 25}}
                 .dump() +
             "\n";
    values.push_back(value);
  }
  std::istringstream answers(here.run("batch -", lines).out);
  std::string line;
  for (const std::string& expected : values) {
    REQUIRE(std::getline(answers, line));
    CAPTURE(line);
    CHECK(contains(line, expected.substr(0, 23)));
  }
}

}  // namespace found_test
