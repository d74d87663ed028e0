// Flat leaves as they are drawn: radiances against the model's double-precision reference.
#include "leaf_rig.h"

using namespace leaf_rig;

namespace {

// The real number: a flat leaf, one far light, radiance = BRDF or BTDF times E times cosine.
void flat_leaf_has_the_models_radiance(void **)
{
    const double E = 2.5;
    double worst_through = 0.0, worst_back = 0.0;
    for (const tsu_model *model : {tsu_leaf(), tsu_leaf_body()}) {
        for (const double T : {0.126, 0.03}) {
            Row row;
            row.T = T;
            take(single(quad()), model, row);
            for (const double mu0 : {1.0, 0.8, 0.4}) {
                for (const double mu : {1.0, 0.6}) {
                    for (const bool below : {false, true}) {
                        for (const bool through : {false, true}) {
                            row.mu0 = mu0;
                            row.mu = mu;
                            row.from_below = below;
                            row.through = through;
                            // Light comes from -x, the view leaves sideways.
                            row.phi = 0.5 * pi;
                            const double light = below ? -1.0 : 1.0;
                            const double view = through ? -light : light;
                            const glm::dvec3 l(-std::sqrt(1.0 - mu0 * mu0), 0.0, light * mu0);
                            const glm::dvec3 v(0.0, std::sqrt(1.0 - mu * mu), view * mu);
                            draw::SurfaceFrame f = frame(v);
                            f.lights = {sun(l, E)};
                            const double seen = mean(drawn(f), 1);
                            const double truth = row.reference(model) * E * mu0;
                            const double off = seen / truth - 1.0;
                            double &worst = through ? worst_through : worst_back;
                            worst = std::max(worst, std::fabs(off));
                            const bool normal = mu0 == 1.0 && mu == 1.0;
                            if (normal && through && std::fabs(off) > 0.02) {
                                fail_msg("T %g: radiance %g, BTDF times E %g", T, seen, truth);
                            }
                        }
                    }
                }
            }
        }
    }
    std::printf("flat leaf against the reference: through %.2f %%, back %.2f %% at worst\n",
                100.0 * worst_through, 100.0 * worst_back);
    assert_true(worst_through < 0.05 && worst_back < 0.05);
}

void both_sides_cover_the_same(void **)
{
    take(single(quad()), tsu_leaf_body(), {});
    for (const double z : {1.0, -1.0}) {
        draw::SurfaceFrame f = frame({0.0, 0.0, z});
        f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
        // Half of the picture's side is the leaf's.
        assert_true(std::fabs(mean(drawn(f), -1) - 0.25) < 1e-6);
    }
}

// Light of equal radiance from everywhere: what a leaf without absorption gives back. Without its
// gloss it lacks what the wall reflects.
void white_leaf_vanishes_in_a_white_sky(void **)
{
    for (const tsu_model *model : {tsu_leaf(), tsu_leaf_body()}) {
        const double gloss = model == tsu_leaf() ? 0.0 : 0.45 * 0.45 / (2.45 * 2.45);
        Row row;
        row.absorption = 0.0;
        renderer->load(single(quad()));
        std::vector<std::max_align_t> params = row.params(model);
        for (uint32_t i = 0;; i++) {
            tsu_parameter_info p;
            tsu_parameter_info_init(&p);
            if (tsu_model_parameter(model, i, &p) != TSU_OK) {
                break;
            }
            if (std::string(p.name).rfind("absorption", 0) == 0) {
                std::memset(reinterpret_cast<char *>(params.data()) + p.offset, 0,
                            p.count * sizeof(float));
            }
        }
        assert_true(bool(renderer->material(model, params.data())));
        for (const double angle : {0.0, 40.0, 65.0}) {
            const double a = angle * pi / 180.0;
            draw::SurfaceFrame f = frame({0.0, std::sin(a), std::cos(a)});
            f.sky[0] = f.sky[1] = f.sky[2] = 0.7f;
            const double back = mean(drawn(f), 1) / 0.7;
            std::printf("white leaf in a white sky at %g degrees: %.4f\n", angle, back);
            assert_true(back < 1.03 && back > (angle < 50.0 ? 0.97 : 0.85) - gloss);
            assert_true(model != tsu_leaf() || std::fabs(back - 1.0) < 0.03);
        }
        // Lit from one side alone, both sides together: the same power, by way of two pictures.
        double sum = 0.0;
        for (const double z : {1.0, -1.0}) {
            draw::SurfaceFrame f = frame({0.0, 0.0, z});
            f.sky[0] = f.sky[1] = f.sky[2] = 0.5f;
            f.sky[12] = f.sky[13] = f.sky[14] = 0.5f; // radiance 0.5 + 0.5 z
            sum += mean(drawn(f), 1);
        }
        assert_true(std::fabs(sum + gloss - 1.0) < 0.03);
    }
}

void sides_differ(void **)
{
    Row row;
    row.R_top = 0.05;
    row.R_bottom = 0.16;
    take(single(quad()), tsu_leaf_body(), row);
    double side[2];
    for (int i = 0; i < 2; i++) {
        const glm::dvec3 z(0.0, 0.0, i == 0 ? 1.0 : -1.0);
        draw::SurfaceFrame f = frame(z);
        f.lights = {sun(z, 1.0)};
        side[i] = mean(drawn(f), 1);
    }
    assert_true(side[1] > 2.0 * side[0]);
}

// The maps' factors reach the model.
void factors_reach_the_model(void **)
{
    Row row;
    Plant plant = single(quad());
    for (const double pigment : {0.5, 1.8}) {
        for (const double thickness : {0.6, 1.7}) {
            plant.leaves[0].pigment = float(pigment);
            plant.leaves[0].thickness = 1.0f;
            plant.maps = {2,
                          2,
                          1.0,
                          std::vector<float>(4, 1.0f),
                          std::vector<float>(4, float(thickness)),
                          std::vector<float>(4, 0.0f),
                          std::vector<unsigned char>(4, 1)};
            take(plant, tsu_leaf_body(), row);
            draw::SurfaceFrame f = frame({0.0, 0.0, -1.0});
            f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
            Row changed = row;
            changed.through = true;
            changed.absorption = pigment;
            changed.thickness = thickness;
            const double truth = changed.reference(tsu_leaf_body());
            assert_true(std::fabs(mean(drawn(f), 1) / truth - 1.0) < 0.04);
        }
    }
}

// leaf_coarse has no answer of its own to even light: it is summed over directions, and comes to
// what leaf_body says in closed form.
void other_models_are_summed(void **)
{
    for (const double angle : {0.0, 50.0}) {
        for (const double side : {1.0, -1.0}) {
            const double a = angle * pi / 180.0;
            double seen[2];
            for (int i = 0; i < 2; i++) {
                take(single(quad()), i ? tsu_leaf_body() : tsu_leaf_coarse(), {});
                draw::SurfaceFrame f = frame({std::sin(a), 0.0, side * std::cos(a)});
                f.sky[0] = f.sky[1] = f.sky[2] = 1.0f;
                f.lights = {sun({0.3, 0.2, 1.0}, 1.0)};
                seen[i] = mean(drawn(f), 1);
            }
            assert_true(std::fabs(seen[0] / seen[1] - 1.0) < 0.05);
        }
    }
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(flat_leaf_has_the_models_radiance),
        cmocka_unit_test(both_sides_cover_the_same),
        cmocka_unit_test(white_leaf_vanishes_in_a_white_sky),
        cmocka_unit_test(sides_differ),
        cmocka_unit_test(factors_reach_the_model),
        cmocka_unit_test(other_models_are_summed),
    };
    return run("leaf_draw", tests);
}
