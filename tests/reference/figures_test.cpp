// Figures from one film: without bias, with honest errors, and the same as those of batches on a
// traced scene, through the file that `tsuya reference` writes.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "reference/cells.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <thread>
#include <utility>

extern "C" {
#include <cmocka.h>
}

namespace
{

using namespace tsuya;
using namespace tsuya::reference;

constexpr int size = 24;

// A grey picture with some pixels that are no hair.
std::vector<float> grey(double value)
{
    std::vector<float> pixels;
    for (int i = 0; i < size * size; i++) {
        pixels.insert(pixels.end(), 3, float(value));
        pixels.push_back(i % 7 ? 1.0f : 0.0f);
    }
    return pixels;
}

// Every pixel is black or twice as bright as the truth, by chance: of 400 films.
void one_film_has_no_bias(void **)
{
    constexpr int rounds = 400, samples = 64;
    const double truth = 0.5, off = 0.05;
    const std::vector<float> picture = grey(truth + off);
    double mean = 0.0, mean_spread = 0.0, mean_stated = 0.0;
    double mse = 0.0, mse_spread = 0.0, mse_stated = 0.0, raw = 0.0;
    for (int round = 0; round < rounds; round++) {
        Film film(size, size);
        for (int i = 0; i < size * size; i++) {
            Random random(std::uint64_t(round), std::uint64_t(i), 0);
            for (int n = 0; n < samples; n++) {
                Sample s;
                s.radiance = glm::dvec3(random.unit() < 0.5 ? 0.0 : 2.0 * truth);
                film.at(i % size, i / size).add(s);
            }
        }
        const image::Traced one = traced(film);
        const Figures f = image::figures(one, {picture.data()})[0];
        raw += image::measures(one, {picture.data()})[0].rel_mse / rounds;
        mean += f.mean_error.value / rounds;
        mean_spread += f.mean_error.value * f.mean_error.value / rounds;
        mean_stated += f.mean_error.error * f.mean_error.error / rounds;
        mse += f.rel_mse.value / rounds;
        mse_spread += f.rel_mse.value * f.rel_mse.value / rounds;
        mse_stated += f.rel_mse.error * f.rel_mse.error / rounds;
    }
    const double expected = off * off / (truth * truth * 1.01);
    mean_spread = std::sqrt(mean_spread - mean * mean);
    mse_spread = std::sqrt(mse_spread - mse * mse);
    std::printf("mean error %.5f of %.5f, spread %.5f, stated %.5f\n"
                "rel MSE %.5f of %.5f (%.5f with its bias), spread %.5f, stated %.5f\n",
                mean, off / truth, mean_spread, std::sqrt(mean_stated), mse, expected, raw,
                mse_spread, std::sqrt(mse_stated));
    assert_true(std::abs(mean - off / truth) < 3.0 * mean_spread / std::sqrt(double(rounds)));
    assert_true(std::abs(mse - expected) < 3.0 * mse_spread / std::sqrt(double(rounds)));
    assert_true(std::abs(mean_spread / std::sqrt(mean_stated) - 1.0) < 0.15);
    assert_true(std::abs(mse_spread / std::sqrt(mse_stated) - 1.0) < 0.15);
}

// By hand: a film without noise, a picture twice as bright in red.
void figures_are_what_they_say(void **)
{
    image::Traced flat = {size, size, {}, {}};
    flat.mean.assign(size * size,
                     {0.5, 0.25, 0.125, 0.2126 * 0.5 + 0.7152 * 0.25 + 0.0722 * 0.125});
    flat.error.assign(size * size, {0.0, 0.0, 0.0, 0.0});
    std::vector<float> picture = grey(0.25);
    for (std::size_t i = 0; i < picture.size(); i += 4) {
        picture[i] = 1.0f;
        picture[i + 2] = 0.125f;
    }
    const Figures f = image::figures(flat, {picture.data()})[0];
    assert_true(std::abs(f.rel_mse.value - 1.0 / 3.0 / 1.01) < 1e-12 && f.rel_mse.error == 0.0);
    assert_true(std::abs(f.channel_error[0].value - 1.0) < 1e-12);
    assert_true(std::abs(f.mean_error.value - 0.2126 * 0.5 / flat.mean[0][3]) < 1e-12);
    assert_true(std::abs(image::rms(f.rel_mse).value - std::sqrt(f.rel_mse.value)) < 1e-12);
    assert_int_equal(image::hair_pixels(flat, picture.data()), size * size - (size * size + 6) / 7);
    const Figure none_left = image::rms({-0.1, 0.04});
    assert_true(none_left.value == 0.0 && std::abs(none_left.error - 0.1) < 1e-12);

    // Its map: red where hair is, grey elsewhere, blue to red below.
    const image::Image map = image::error_map(flat, picture.data());
    assert_int_equal(map.width, size);
    assert_int_equal(map.pixels.size(), 3 * map.width * map.height);
    const float *const hair = &map.pixels[3], *const none = &map.pixels[0];
    assert_true(hair[0] > hair[1] && hair[1] == hair[2]);
    assert_true(none[0] == none[1] && none[1] == none[2]);
    const float *const last = &map.pixels[map.pixels.size() - 3 * std::size_t(size)];
    assert_true(last[2] > 2.0f * last[0] && last[3 * (size - 1)] > 2.0f * last[3 * size - 1]);
}

void refuses_what_is_not_traced(void **)
{
    Film film(2, 2);
    const image::Image good = film.image();
    image::Traced result;
    std::string error;
    assert_true(image::traced(good, result, error));
    for (const char *name : {"R", "se.G"}) {
        image::Image bad = good;
        bad.names[std::size_t(image::channel(good, name))] = "other";
        assert_false(image::traced(bad, result, error));
        assert_non_null(std::strstr(error.c_str(), name));
    }
    image::Image bad = good;
    bad.pixels[8] = std::numeric_limits<float>::quiet_NaN();
    assert_false(image::traced(bad, result, error));
    assert_non_null(std::strstr(error.c_str(), "(1, 0)"));
    bad.pixels[8] = 0.0f;
    bad.pixels[13] = -1.0f;
    assert_false(image::traced(bad, result, error));
    assert_non_null(std::strstr(error.c_str(), "negative"));
}

// Against the jackknife on a traced head. Both have the same noise, so that they differ by much
// less than it.
void one_film_is_as_good_as_batches(void **)
{
    Expected<std::unique_ptr<scene::Studio>> studio = scene::Studio::create();
    assert_true(bool(studio));
    const Cell cell = {"curly", "brown", "side", 1.5, 40, 3};
    const std::vector<Tier> two = {tiers()[1], tiers()[5]};
    const Expected<std::vector<Taken>> drawn = draw_cells(**studio, {cell}, two);
    assert_true(bool(drawn));
    const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    const Expected<Result> result = trace(drawn->front(), {64, 64, threads, {}});
    assert_true(bool(result));
    std::string error;
    image::Image file;
    image::Traced read;
    assert_true(image::write_exr("figures_test.exr", result->film.image(), error));
    assert_true(image::read_exr("figures_test.exr", file, error));
    assert_true(image::traced(file, read, error));
    std::remove("figures_test.exr");
    std::vector<image::Pixels> pixels;
    for (const draw::Picture &picture : drawn->front().pictures) {
        pixels.push_back(picture.pixels.data());
    }
    const std::vector<Figures> one = image::figures(read, pixels);
    for (std::size_t k = 0; k < two.size(); k++) {
        const auto hold = [&](const char *name, const Figure &a, const Figure &b) {
            const double off = std::abs(a.value - b.value) / b.error;
            std::printf("%s %s: one film %.5f +- %.5f, batches %.5f +- %.5f, %.2f errors off\n",
                        two[k].name, name, a.value, a.error, b.value, b.error, off);
            assert_true(off < 1.0);
            // That of 16 batches is itself known to 18 %.
            assert_true(a.error > 0.6 * b.error && a.error < 1.6 * b.error);
        };
        const Figures &batches = result->figures[k];
        hold("mean", one[k].mean, batches.mean);
        hold("mean error", one[k].mean_error, batches.mean_error);
        hold("rel MSE", one[k].rel_mse, batches.rel_mse);
        for (std::size_t c = 0; c < 3; c++) {
            hold("a channel's mean error", one[k].channel_error[c], batches.channel_error[c]);
            hold("a channel's rel MSE", one[k].channel_mse[c], batches.channel_mse[c]);
        }
    }
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(one_film_has_no_bias),
        cmocka_unit_test(figures_are_what_they_say),
        cmocka_unit_test(refuses_what_is_not_traced),
        cmocka_unit_test(one_film_is_as_good_as_batches),
    };
    return cmocka_run_group_tests_name("figures", tests, nullptr, nullptr);
}
