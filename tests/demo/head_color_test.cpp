// The colour of a head in a scene: said, written, read, and what comes of it.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "scene/build.h"

#include <tsuya/hair_color.h>

#include <cmath>
#include <string>

extern "C" {
#include <cmocka.h>
}

using namespace tsuya;

namespace {

// The colour asked for is the one that thick hair of the scene's own fibre shows.
void heads_have_the_albedo_asked_for(void **)
{
    const double asked[3] = {0.4, 0.2, 0.1};
    for (const std::string fibre : {"model=marschner", "model=kajiya_kay", "beta_az_deg=25"}) {
        const groom::Expected<scene::Scene> dyed =
            scene::override({}, {"head_albedo=0.4,0.2,0.1", fibre});
        assert_true(bool(dyed) && dyed->color_by == scene::ColorBy::head_albedo);
        const groom::Expected<scene::Scene> again = scene::parse(scene::write(*dyed), "again");
        assert_true(bool(again) && *again == *dyed && again->head_albedo == dyed->head_albedo);
        const groom::Expected<scene::Material> material = scene::material(*again);
        if (!material) {
            fail_msg("%s", material.error().c_str());
        }
        tsu_hair_head_desc desc;
        tsu_hair_head_desc_init(&desc);
        if (fibre == "beta_az_deg=25") {
            desc.beta_az = float(25.0 * 0.01745329251994329577);
        }
        tsu_hair_head_curve curve;
        tsu_hair_head_curve_init(&curve);
        tsu_context_desc context_desc;
        tsu_context_desc_init(&context_desc);
        tsu_context *context = nullptr;
        assert_int_equal(tsu_context_create(&context_desc, &context), TSU_OK);
        assert_int_equal(tsu_hair_head_curve_solve(context, &desc, &curve), TSU_OK);
        double shown[3];
        assert_int_equal(tsu_hair_head_albedo(context, &curve, &material->sigma_a.x, shown),
                         TSU_OK);
        for (int c = 0; c < 3; c++) {
            assert_true(std::fabs(shown[c] - asked[c]) <= 1e-9);
        }
        tsu_context_destroy(context);
    }
    const groom::Expected<scene::Material> black =
        scene::material(*scene::override({}, {"head_albedo=0.4,0.2,0.013"}));
    assert_false(bool(black));
    assert_true(black.error().find("head_albedo") != std::string::npos);
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(heads_have_the_albedo_asked_for)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
