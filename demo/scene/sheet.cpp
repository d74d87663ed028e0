#include "scene/sheet.h"

#include <algorithm>
#include <cmath>

namespace tsuya::scene {

namespace {

constexpr int gap = 4; // pixels between tiles

// The curve of draw/display.frag.glsl.
float toned(double value, const Scene &scene)
{
    const double light = std::max(value * std::exp2(scene.exposure), 0.0);
    if (scene.tone != "film") {
        return float(light);
    }
    const double x = 0.8 * light;
    return float(std::clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0));
}

void put(image::Image &sheet, int left, int top, const image::Image &tile)
{
    for (int y = 0; y < tile.height && top + y < sheet.height; y++) {
        for (int x = 0; x < tile.width && left + x < sheet.width; x++) {
            for (int c = 0; c < 3; c++) {
                sheet.pixels[std::size_t(3 * ((top + y) * sheet.width + left + x) + c)] =
                    tile.pixels[std::size_t(3 * (y * tile.width + x) + c)];
            }
        }
    }
}

} // namespace

image::Image sheet(const Scene &scene, const image::Traced &traced,
                   const std::vector<draw::Picture> &pictures)
{
    const int width = traced.width, height = traced.height, tiles = int(pictures.size()) + 1;
    std::vector<image::Image> maps;
    for (const draw::Picture &picture : pictures) {
        maps.push_back(image::error_map(traced, picture.pixels.data()));
    }
    const int below = maps.empty() ? 0 : gap + maps[0].height;
    image::Image sheet = {tiles * width + (tiles - 1) * gap, height + below, 3, {}};
    sheet.pixels.assign(std::size_t(3) * std::size_t(sheet.width) * std::size_t(sheet.height),
                        1.0f);
    image::Image tile = {width, height, 3, {}};
    tile.pixels.resize(std::size_t(3 * width * height));
    for (int k = 0; k < tiles; k++) {
        for (int i = 0; i < width * height; i++) {
            for (int c = 0; c < 3; c++) {
                const double value =
                    k == 0 ? traced.mean[std::size_t(i)][std::size_t(c)]
                           : double(pictures[std::size_t(k - 1)].pixels[std::size_t(4 * i + c)]);
                tile.pixels[std::size_t(3 * i + c)] = toned(value, scene);
            }
        }
        put(sheet, k * (width + gap), 0, tile);
        if (k > 0) {
            put(sheet, k * (width + gap), height + gap, maps[std::size_t(k - 1)]);
        }
    }
    return sheet;
}

} // namespace tsuya::scene
