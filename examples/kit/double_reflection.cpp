// Frames for all curves of the reference collection by double reflection (Wang, Jüttler, Zheng, Liu
// 2008), to be judged by phrame check --suite. Put your own method in the place of next_normal().
//
//     phrame reference --export collection --samples 51,101,201
//     c++ -std=c++17 -O2 double_reflection.cpp -o double_reflection
//     ./double_reflection collection/frames mine
//     phrame check --suite mine
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// a - k b
Vector minus(const Vector& a, double k, const Vector& b) {
  return {a[0] - k * b[0], a[1] - k * b[1], a[2] - k * b[2]};
}

struct Row {
  std::string t;
  Vector r, e1, f2;
};

/// f2 at the next point: reflected in the plane between the points, then so that the tangent
/// becomes that of the next.
Vector next_normal(const Row& at, Vector f2, const Row& next) {
  Vector e1 = at.e1;
  const Vector way = minus(next.r, 1, at.r);
  if (const double c = dot(way, way); c > 0) {  // else it is the same point
    f2 = minus(f2, 2 * dot(way, f2) / c, way);
    e1 = minus(e1, 2 * dot(way, e1) / c, way);
  }
  const Vector turn = minus(next.e1, 1, e1);
  const double c = dot(turn, turn);
  return c > 0 ? minus(f2, 2 * dot(turn, f2) / c, turn) : f2;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<Row> read_rows(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> head = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    std::map<std::string, std::string> row;
    const std::vector<std::string> cells = cells_of(line);
    for (std::size_t k = 0; k < cells.size(); ++k) row[head.at(k)] = cells[k];
    const auto vector = [&](const std::string& x, const std::string& y, const std::string& z) {
      return Vector{std::stod(row.at(x)), std::stod(row.at(y)), std::stod(row.at(z))};
    };
    rows.push_back({row.at("t"), vector("x", "y", "z"), vector("e1x", "e1y", "e1z"),
                    vector("f2x", "f2y", "f2z")});
  }
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "double_reflection collection/frames mine\n";
    return 2;
  }
  fs::create_directories(argv[2]);
  std::ofstream times(fs::path(argv[2]) / "times.csv");
  times << "name,seconds\n";
  for (const auto& entry : fs::recursive_directory_iterator(argv[1])) {
    if (entry.path().extension() != ".csv") continue;
    const std::vector<Row> rows = read_rows(entry.path());
    const auto start = std::chrono::steady_clock::now();
    std::vector<Vector> normals{rows.at(0).f2};  // where the exact frame starts
    for (std::size_t k = 1; k < rows.size(); ++k)
      normals.push_back(next_normal(rows[k - 1], normals.back(), rows[k]));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    fs::path name = fs::relative(entry.path(), argv[1]);
    const fs::path target = argv[2] / name;
    times << name.replace_extension().generic_string() << ',' << seconds.count() << '\n';
    fs::create_directories(target.parent_path());
    std::ofstream out(target);
    out.precision(17);
    out << "t,f2x,f2y,f2z\n";
    for (std::size_t k = 0; k < rows.size(); ++k)
      out << rows[k].t << ',' << normals[k][0] << ',' << normals[k][1] << ',' << normals[k][2]
          << '\n';
  }
}
