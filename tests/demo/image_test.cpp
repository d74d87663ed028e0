// Picture files: what is written is read back, the sRGB curve has its known values, and what cannot
// be written or read says so and leaves nothing behind.
#include "../../demo/image/image.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>

// Last: it defines common words such as fail as macros.
extern "C" {
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
}

using namespace tsuya::image;

namespace {

std::filesystem::path folder;

std::string in_folder(const char *name)
{
    return (folder / name).string();
}

// Different in every value, within [0, 1).
Image ramp(int width, int height, int channels)
{
    Image image{width, height, channels, {}};
    const int count = width * height * channels;
    for (int i = 0; i < count; i++) {
        image.pixels.push_back(float(i) / float(count));
    }
    return image;
}

void srgb_known_values(void **)
{
    assert_int_equal(int(srgb_encode(0.5F) * 255 + 0.5F), 188);
    assert_int_equal(int(srgb_encode(0.18F) * 255 + 0.5F), 118);
    assert_float_equal(srgb_encode(0.0031308F), 0.0404500F, 1e-6);
    assert_float_equal(srgb_encode(0.001F), 0.01292F, 1e-7);
    assert_float_equal(srgb_encode(-1.0F), 0.0F, 0);
    assert_float_equal(srgb_encode(7.0F), 1.0F, 0);
    for (int i = 0; i <= 1000; i++) {
        const float x = float(i) / 1000;
        assert_float_equal(srgb_decode(srgb_encode(x)), x, 1e-6);
    }
}

void png_round_trip(void **)
{
    const std::string path = in_folder("a.png");
    std::string error;
    for (int channels = 1; channels <= 4; channels++) {
        for (const Depth depth : {Depth::eight, Depth::sixteen}) {
            const Image image = ramp(7, 5, channels);
            Image back;
            assert_true(write_png(path, image, error, depth));
            assert_true(read_png(path, back, error));
            assert_int_equal(back.width, 7);
            assert_int_equal(back.height, 5);
            assert_int_equal(back.channels, channels);
            assert_int_equal(back.pixels.size(), image.pixels.size());
            // Half a level, times the steepest slope of the decoding curve, 2.4 / 1.055.
            const double bound = (depth == Depth::eight ? 0.5 / 255 : 0.5 / 65535) * 2.2749 + 1e-6;
            for (std::size_t i = 0; i < image.pixels.size(); i++) {
                assert_float_equal(back.pixels[i], image.pixels[i], bound);
            }
        }
    }
    assert_string_equal(error.c_str(), "");
}

// Levels as they are: what is on the curve in the file, for every number of channels and bits.
void png_without_a_curve(void **)
{
    const std::string path = in_folder("a.png");
    std::string error;
    for (int channels = 1; channels <= 4; channels++) {
        for (const Depth depth : {Depth::eight, Depth::sixteen}) {
            const Image image = ramp(7, 5, channels);
            Image back;
            assert_true(write_png(path, image, error, depth));
            assert_true(read_png(path, back, error, Curve::none));
            const double bound = (depth == Depth::eight ? 0.5 / 255 : 0.5 / 65535) + 1e-6;
            for (std::size_t i = 0; i < image.pixels.size(); i++) {
                const bool alpha = channels % 2 == 0 && int(i) % channels == channels - 1;
                const float there = alpha ? image.pixels[i] : srgb_encode(image.pixels[i]);
                assert_float_equal(back.pixels[i], there, bound);
            }
        }
    }
}

void png_alpha_is_linear(void **)
{
    const std::string path = in_folder("alpha.png");
    std::string error;
    Image back;
    assert_true(write_png(path, Image{1, 1, 4, {2.0F, -1.0F, 0.5F, 0.5F}}, error));
    assert_true(read_png(path, back, error));
    assert_float_equal(back.pixels[0], 1, 0);
    assert_float_equal(back.pixels[1], 0, 0);
    assert_float_equal(back.pixels[2], srgb_decode(188 / 255.0F), 0);
    assert_float_equal(back.pixels[3], 128 / 255.0F, 0);
}

void exr_round_trip(void **)
{
    const std::string path = in_folder("a.exr");
    std::string error;
    for (int channels = 1; channels <= 4; channels++) {
        Image image = ramp(33, 21, channels);
        image.pixels[0] = std::numeric_limits<float>::infinity();
        image.pixels[1] = -1e30F;
        Image back;
        assert_true(write_exr(path, image, error));
        assert_true(read_exr(path, back, error));
        assert_int_equal(back.width, 33);
        assert_int_equal(back.height, 21);
        assert_int_equal(back.channels, channels);
        assert_true(back.pixels == image.pixels);
    }
}

void exr_named_channels(void **)
{
    const std::string path = in_folder("table.exr");
    std::string error;
    Image table = ramp(4, 3, 6);
    table.names = {"TRT.G", "m_r", "R", "TRT.B", "A", "TRT.R"};
    table.texts = {{"scene", "a=1\nb = \xc3\xa4\n"}, {"samples", "64"}};
    Image back;
    assert_true(write_exr(path, table, error));
    assert_true(read_exr(path, back, error));
    assert_int_equal(back.channels, 6);
    assert_true(back.texts == table.texts);
    assert_string_equal(back.names[0].c_str(), "R");
    assert_string_equal(back.names[1].c_str(), "A");
    assert_int_equal(channel(back, "none"), -1);
    for (int c = 0; c < 6; c++) {
        const int there = channel(back, table.names[std::size_t(c)]);
        assert_true(there >= 0);
        for (int i = 0; i < 12; i++) {
            assert_true(back.pixels[std::size_t(i * 6 + there)] ==
                        table.pixels[std::size_t(i * 6 + c)]);
        }
    }
    assert_int_equal(channel(ramp(1, 1, 4), "A"), 3);
}

void writing_refuses(void **)
{
    std::string error;
    const std::string nowhere = in_folder("no/such/folder/a.png");
    assert_false(write_png(nowhere, ramp(2, 2, 3), error));
    assert_true(error.find(nowhere) != std::string::npos);
    error.clear();
    assert_false(write_exr(nowhere, ramp(2, 2, 3), error));
    assert_true(error.find(nowhere) != std::string::npos);

    const std::string kept = in_folder("kept.png");
    assert_true(write_png(kept, ramp(2, 2, 3), error));
    Image bad = ramp(2, 2, 3);
    bad.pixels[5] = std::nanf("");
    assert_false(write_png(kept, bad, error));
    bad.pixels.pop_back();
    assert_false(write_png(kept, bad, error));
    assert_false(write_exr(kept, bad, error));
    assert_false(write_png(kept, ramp(2, 2, 5), error));
    assert_false(write_exr(kept, ramp(2, 2, 5), error));
    Image twice = ramp(2, 2, 2);
    twice.names = {"a", "a"};
    assert_false(write_exr(kept, twice, error));
    assert_false(write_png(kept, Image{}, error));
    Image back;
    assert_true(read_png(kept, back, error));

    // A folder stands where the file should go: the rename fails after the file is written.
    std::filesystem::create_directory(in_folder("taken.png"));
    assert_false(write_png(in_folder("taken.png"), ramp(2, 2, 3), error));
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        assert_true(entry.path().extension() != ".part");
    }
}

void reading_refuses(void **)
{
    std::string error;
    Image image = ramp(1, 1, 1);
    const Image before = image;
    assert_false(read_png(in_folder("none.png"), image, error));
    assert_true(error.find("none.png") != std::string::npos);
    assert_false(read_exr(in_folder("none.exr"), image, error));

    std::ofstream(in_folder("text")) << "this is not a picture, only a line of text";
    assert_false(read_png(in_folder("text"), image, error));
    assert_false(read_exr(in_folder("text"), image, error));

    const std::string cut = in_folder("cut");
    assert_true(write_png(cut, ramp(64, 64, 3), error));
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) / 2);
    assert_false(read_png(cut, image, error));
    assert_true(write_exr(cut, ramp(64, 64, 3), error));
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) / 2);
    assert_false(read_exr(cut, image, error));
    for (std::uintmax_t less : {1u, 2u, 100u}) { // where decoding fails half way
        assert_true(write_exr(cut, ramp(64, 64, 3), error));
        std::filesystem::resize_file(cut, std::filesystem::file_size(cut) - less);
        assert_false(read_exr(cut, image, error));
        assert_true(error.find(cut) != std::string::npos);
    }
    assert_true(image.pixels == before.pixels);
}

int make_folder(void **)
{
    std::string name = (std::filesystem::temp_directory_path() / "image_test_XXXXXX").string();
    if (!mkdtemp(name.data())) {
        return -1;
    }
    folder = name;
    return 0;
}

int remove_folder(void **)
{
    std::filesystem::remove_all(folder);
    return 0;
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(srgb_known_values),   cmocka_unit_test(png_round_trip),
        cmocka_unit_test(png_alpha_is_linear), cmocka_unit_test(exr_round_trip),
        cmocka_unit_test(exr_named_channels),  cmocka_unit_test(writing_refuses),
        cmocka_unit_test(reading_refuses),     cmocka_unit_test(png_without_a_curve),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
