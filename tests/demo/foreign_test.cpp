// A stranger's renderer: what `tsuya glsl` prints and `tsuya bake` writes gives `tsuya eval`'s
// numbers.
//
//     foreign_test /path/to/tsuya
//
// Links no part of the library. The harness text is compiled as it comes, the texture and the block
// are uploaded from the files, and one point is drawn for each of a few dozen random directions.
#include "foreign_draw.h"

#include "offscreen.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using foreign::Vertex;

constexpr int directions = 64;
constexpr double degree = 0.01745329251994329577;

// A direction by its angles and in world space; the CSV takes the angles, the vertex the vectors.
struct Direction {
    double theta_i, theta_r, phi;
    double sigma_a[3];
    Vertex vertex;
};

struct Case {
    const char *model;
    double eta, alpha, beta, beta_az; // degrees
};

std::string command;
std::filesystem::path folder;
int failures = 0;

void check(bool good, const std::string &what)
{
    std::printf("%s %s\n", good ? "pass" : "FAIL", what.c_str());
    failures += !good;
}

[[noreturn]] void stop(const std::string &why)
{
    std::printf("FAIL %s\n", why.c_str());
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    std::exit(1);
}

// Standard output of `tsuya arguments`; the test ends when the command fails.
std::string run(const std::string &arguments)
{
    const std::string line = "'" + command + "' " + arguments;
    std::FILE *const pipe = popen(line.c_str(), "r");
    std::string text;
    char buffer[4096];
    for (std::size_t size = 1; pipe && size > 0;) {
        size = std::fread(buffer, 1, sizeof buffer, pipe);
        text.append(buffer, size);
    }
    if (!pipe || pclose(pipe) != 0) {
        stop("the command failed: " + line);
    }
    return text;
}

std::string bytes_of(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<Direction> random_directions()
{
    std::mt19937 random(20240521);
    const auto between = [&](double low, double high) {
        return low + (high - low) * (double(random()) / 4294967296.0);
    };
    std::vector<Direction> all;
    for (int i = 0; i < directions; i++) {
        // An orthonormal frame from a random tangent (Duff et al. 2017).
        const double z = between(-0.99, 0.99), turn = between(0, 360) * degree;
        const double x = std::sqrt(1 - z * z) * std::cos(turn),
                     y = std::sqrt(1 - z * z) * std::sin(turn);
        const double sign = z < 0 ? -1 : 1, a = -1 / (sign + z), b = x * y * a;
        const double t[3] = {x, y, z};
        const double u[3] = {1 + sign * x * x * a, sign * b, -sign * x};
        const double w[3] = {b, sign + y * y * a, -y};
        Direction d = {};
        d.theta_i = between(-80, 80);
        // Half of the views lie near the cone of the highlights.
        d.theta_r =
            i % 2 ? between(-80, 80) : std::fmax(-80, std::fmin(80, between(-15, 15) - d.theta_i));
        d.phi = between(-180, 180);
        const double si = std::sin(d.theta_i * degree), ci = std::cos(d.theta_i * degree);
        const double sr = std::sin(d.theta_r * degree), cr = std::cos(d.theta_r * degree);
        const double cp = std::cos(d.phi * degree), sp = std::sin(d.phi * degree);
        for (int k = 0; k < 3; k++) {
            d.sigma_a[k] = double(float(between(0, k + 0.5)));
            d.vertex.t[k] = float(t[k]);
            d.vertex.l[k] = float(si * t[k] + ci * u[k]);
            d.vertex.v[k] = float(sr * t[k] + cr * (cp * u[k] + sp * w[k]));
            d.vertex.sigma_a[k] = float(d.sigma_a[k]);
        }
        all.push_back(d);
    }
    return all;
}

// What eval says: one row for each direction and channel; the last column is the total.
std::vector<double> evaluated(const Case &c, const std::vector<Direction> &all)
{
    const std::filesystem::path path = folder / "rows.csv";
    std::FILE *const file = std::fopen(path.c_str(), "w");
    std::fprintf(
        file, "theta_i_deg,theta_r_deg,phi_deg,sigma_a,eta,alpha_R_deg,beta_R_deg,beta_az_deg\n");
    for (const Direction &d : all) {
        for (const double sigma_a : d.sigma_a) {
            std::fprintf(file, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", d.theta_i,
                         d.theta_r, d.phi, sigma_a, c.eta, c.alpha, c.beta, c.beta_az);
        }
    }
    std::fclose(file);
    std::istringstream text(
        run("eval hair --on gpu --model " + std::string(c.model) + " '" + path.string() + "'"));
    std::vector<double> totals;
    std::string line;
    std::getline(text, line);
    while (std::getline(text, line)) {
        totals.push_back(std::strtod(line.c_str() + line.rfind(',') + 1, nullptr));
    }
    return totals;
}

// The exponent of the narrowest lobe, near -1/v with v its variance, is a sum of rounded products
// and of angles or vectors rounded to float: a few units of 2^-24 / v, relative to the peak.
double tolerance(const Case &c)
{
    const double narrowest = 0.5 * c.beta * degree;
    return std::fmax(1e-5, 8.0 / 16777216.0 / (narrowest * narrowest));
}

void compare(const gl_api &gl, const Case &c, const std::vector<Direction> &all)
{
    char keys[256];
    std::snprintf(keys, sizeof keys, "eta=%.17g alpha_R_deg=%.17g beta_R_deg=%.17g", c.eta, c.alpha,
                  c.beta);
    std::string words = std::string(c.model) + " " + keys;
    if (c.beta_az > 0) {
        std::snprintf(keys, sizeof keys, " beta_az_deg=%.17g", c.beta_az);
        words += keys;
    }
    const std::filesystem::path texture = folder / "tables.bin", block = folder / "page.block";
    run("bake " + words + " --no-measure -o '" + texture.string() + "' --block '" + block.string() +
        "' > /dev/null");
    const std::string harness = run("glsl " + std::string(c.model) + " --target 330 --harness");
    foreign::use_program(gl, harness, all.size());
    foreign::upload(gl, bytes_of(texture), bytes_of(block));
    std::vector<Vertex> vertices;
    for (const Direction &d : all) {
        vertices.push_back(d.vertex);
    }
    const std::vector<float> pixels = foreign::drawn(gl, vertices);
    const std::vector<double> totals = evaluated(c, all);
    if (totals.size() != 3 * directions) {
        stop("eval printed " + std::to_string(totals.size()) + " rows");
    }
    double peak = 0, worst = 0;
    for (std::size_t i = 0; i < totals.size(); i++) {
        const double error = std::fabs(double(pixels[4 * (i / 3) + i % 3]) - totals[i]);
        peak = std::fmax(peak, totals[i]);
        worst = error >= worst ? error : std::isfinite(error) ? worst : INFINITY;
    }
    char text[256];
    std::snprintf(text, sizeof text,
                  "%s: harness against eval, worst %.2g of the peak %.4g (allowed %.2g)",
                  words.c_str(), worst / peak, peak, tolerance(c));
    check(peak > 0 && worst <= tolerance(c) * peak && gl.GetError() == GL_NO_ERROR, text);
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: foreign_test /path/to/tsuya\n");
        return 2;
    }
    command = argv[1];
    std::string name = (std::filesystem::temp_directory_path() / "tsuya_foreign_XXXXXX").string();
    if (!mkdtemp(&name[0])) {
        stop("no temporary folder");
    }
    folder = name;
    char error[512] = "";
    offscreen *context = nullptr;
    const offscreen_desc desc = {OFFSCREEN_ANY, OFFSCREEN_GL, 3, 3};
    if (!offscreen_create(&desc, &context, error, sizeof error)) {
        stop(std::string("no OpenGL 3.3: ") + error);
    }
    gl_api gl;
    const char *missing = nullptr;
    if (!gl_load(&gl, offscreen_proc, context, &missing)) {
        stop(std::string("OpenGL lacks ") + (missing ? missing : "a function"));
    }
    const std::vector<Direction> all = random_directions();
    const Case cases[] = {{"marschner", 1.55, -10, 25, 12},
                          {"marschner", 1.35, -7.5, 7.5, 6},
                          {"kajiya_kay", 1.55, -10, 25, 0},
                          {"kajiya_kay", 1.8, 5, 8, 0}};
    try {
        for (const Case &c : cases) {
            compare(gl, c, all);
        }
    } catch (const std::exception &failure) {
        stop(failure.what());
    }
    offscreen_destroy(context);
    std::filesystem::remove_all(folder);
    return failures ? 1 : 0;
}
