// Groom readers against files made in memory: good, cut off, lying and mutated ones.
#include "groom_checks.h"

#include <cmath>
#include <limits>
#include <string>

using namespace groom_checks;

namespace {

void reads_tfx(void **)
{
    for (const bool uv : {false, true}) {
        const Result r = load(make_tfx(sample(), uv), Format::tfx);
        assert_true(bool(r));
        expect_strands(r->groom, sample());
        assert_int_equal(r->groom.uv.size(), uv ? 3 : 0);
        if (uv) {
            assert_true(r->groom.uv[2] == glm::vec2(0.25f, 0.75f));
        }
        assert_int_equal(r->report.unused_bytes, 0);
        assert_true(r->report.plausible_size);
    }
}

void reads_hair(void **)
{
    Strands strands = sample();
    strands[1].pop_back();
    const Result r = load(make_hair(strands, 1 | 4 | 8 | 16), Format::hair);
    assert_true(bool(r));
    expect_strands(r->groom, strands);
    assert_int_equal(r->groom.radius.size(), 11);
    assert_true(r->groom.radius[10] == 11.0f / 2048.0f);
    assert_int_equal(r->report.unused_bytes, 11 * 16);

    const Result even = load(make_hair(sample(), 0), Format::hair);
    assert_true(bool(even));
    expect_strands(even->groom, sample());
    assert_true(even->groom.radius.empty());
    assert_true(even->groom.constant_radius == 0.25f);

    Bytes no_width = make_hair(sample(), 0);
    set_float(no_width, 20, 0.0f);
    const Result thin = load(no_width, Format::hair);
    assert_true(thin->groom.constant_radius == 4e-5f);
    assert_int_equal(thin->report.replaced_values, 0);
}

void reads_data(void **)
{
    Strands strands = sample();
    strands[2].pop_back();
    const Result r = load(make_data(strands), Format::data);
    assert_true(bool(r));
    expect_strands(r->groom, strands);
}

void refuses_every_truncation(void **)
{
    const std::pair<Format, Bytes> files[] = {{Format::tfx, make_tfx(sample(), true)},
                                              {Format::tfx, make_tfx(sample(), false)},
                                              {Format::hair, make_hair(sample(), 1 | 4 | 8 | 16)},
                                              {Format::hair, make_hair(sample(), 0)},
                                              {Format::data, make_data(sample())}};
    for (const auto &[format, whole] : files) {
        assert_true(bool(load(whole, format)));
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const Bytes part(whole.begin(), whole.begin() + std::ptrdiff_t(size));
            expect_refused(part, format, {"offset", "bytes"});
        }
    }
}

void refuses_lies_about_counts(void **)
{
    for (const std::uint32_t lie : {0u, 4u, 0x7fffffffu, 0x80000000u, 0xffffffffu}) {
        for (const std::size_t at : {4u, 8u}) {
            Bytes b = make_tfx(sample(), false);
            set32(b, at, lie == 4 && at == 8 ? 5 : lie);
            expect_refused(b, Format::tfx, {"offset"});
            b = make_hair(sample(), 1 | 4);
            set32(b, at, lie);
            expect_refused(b, Format::hair, {"offset"});
        }
        Bytes b = make_data(sample());
        set32(b, 0, lie);
        expect_refused(b, Format::data, {"offset"});
        b = make_data(sample());
        set32(b, 4, lie == 4 ? 5 : lie);
        assert_false(bool(load(b, Format::data)));
    }
    Bytes b = make_tfx(sample(), false);
    set32(b, 4, 0xffffffffu);
    set32(b, 8, 0xffffffffu);
    expect_refused(b, Format::tfx, {"4294967295 x 4294967295 x 16", "192"});
    b = make_hair(sample(), 0);
    set32(b, 16, 0xffffffffu);
    expect_refused(b, Format::hair, {"offset 8", "12884901888"});
    b = make_data(sample());
    set32(b, 0, 0xfffffffeu);
    expect_refused(b, Format::data, {"-2", "[1, 2147483647]"});
    b = make_data(sample());
    b.push_back(0);
    expect_refused(b, Format::data, {"ends at offset", "161 bytes"});
}

void refuses_lies_about_sections(void **)
{
    for (const std::uint32_t lie : {0u, 159u, 161u, 353u, 0x7fffffffu, 0xffffffffu}) {
        Bytes b = make_tfx(sample(), false);
        set32(b, 12, lie);
        expect_refused(b, Format::tfx, {lie == 161 ? "offset 161" : "offset 12"});
    }
    for (const std::uint32_t lie : {1u, 159u, 353u, 0xffffffffu}) {
        Bytes b = make_tfx(sample(), true);
        set32(b, 16, lie);
        expect_refused(b, Format::tfx, {"offset 16", "376"});
    }
    Bytes b = make_tfx(sample(), true);
    set32(b, 16, 200);
    expect_refused(b, Format::tfx, {"overlaps", "[160, 352)"});
    set_float(b, 0, 3.0f);
    expect_refused(b, Format::tfx, {"version", "[4, 5)"});
    set_float(b, 0, std::nanf(""));
    expect_refused(b, Format::tfx, {"version"});
    b = make_hair(sample(), 0);
    set32(b, 12, 0);
    expect_refused(b, Format::hair, {"flags", "offset 12"});
    b[0] = 'h';
    expect_refused(b, Format::hair, {"HAIR"});
}

void drops_and_counts_bad_points(void **)
{
    const float inf = std::numeric_limits<float>::infinity();
    Strands bad = sample(), good = sample();
    bad[0][1].y = std::nanf("");
    bad[0][3].z = -inf;
    good[0] = {good[0][0], good[0][2]};
    bad[1].assign(4, bad[1][0]);
    bad[2][3] = bad[2][2];
    good[2].pop_back();
    good.erase(good.begin() + 1);
    bad.push_back({glm::vec3(inf), glm::vec3(2e15f), glm::vec3(0.0f), glm::vec3(inf)});

    Bytes wide = make_hair(bad, 1 | 4);
    set_float(wide, wide.size() - 16 * 4 + 8, -1.0f); // of the third point: kept, bad width
    Bytes mapped = make_tfx(bad, true);
    set_float(mapped, mapped.size() - 16, inf); // of the third strand
    for (const Result &r : {load(mapped, Format::tfx), load(wide, Format::hair),
                            load(make_data(bad), Format::data)}) {
        assert_true(bool(r));
        expect_strands(r->groom, good);
        check_promises(r->groom);
        assert_int_equal(r->report.non_finite_points, 5);
        assert_int_equal(r->report.degenerate_segments, 4);
        assert_int_equal(r->report.dropped_strands, 2);
        const std::string told = text(r->report);
        expect_error(told, {"5 points dropped", "4 repeated points", "2 strands dropped"});
    }
    // A strand keeps its seed whatever is dropped before it.
    assert_true(load(make_data(bad), Format::data)->groom.seed[1] == strand_seed(2));
    assert_int_equal(load(mapped, Format::tfx)->report.replaced_values, 1);
    assert_true(load(mapped, Format::tfx)->groom.uv[1] == glm::vec2(0.0f));

    Strands none(2, Strand(3, glm::vec3(1.0f)));
    expect_refused(make_data(none), Format::data, {"none of the 2 strands", "4 repeat"});
}

void scales_and_turns(void **)
{
    ReadOptions options;
    options.unit_scale = 0.5;
    options.up = Up::z;
    const Result r = load(make_hair(sample(), 4), Format::hair, options);
    const glm::vec3 p = sample()[2][3];
    assert_true(r->groom.points[11] == glm::vec3(p.x * 0.5f, p.z * 0.5f, -p.y * 0.5f));
    assert_true(r->groom.radius[11] == 12.0f / 4096.0f);

    options.unit_scale = 100.0;
    const Result large = load(make_data(sample()), Format::data, options);
    assert_false(large->report.plausible_size);
    expect_error(text(large->report), {"warning", "unit_scale", "0.2 m"});

    for (const double wrong : {0.0, -1.0, double(NAN), double(INFINITY)}) {
        options.unit_scale = wrong;
        const Result refused = load(make_data(sample()), Format::data, options);
        assert_false(bool(refused));
        expect_error(refused.error(), {"unit_scale", "above 0"});
    }
    options = ReadOptions();
    options.radius = 0.0f;
    expect_error(load(make_data(sample()), Format::data, options).error(), {"radius", "["});
    options = ReadOptions();
    options.unit_scale = 1e300;
    expect_error(load(make_data(sample()), Format::data, options).error(),
                 {"12 points are not finite"});
}

void reports_kinks(void **)
{
    const Strand bent = {{0, 0, 0}, {0.1f, 0, 0}, {0.1f, 0.1f, 0}, {0.05f, 0.05f, 0}, {0.1f, 0, 0}};
    Strands strands = sample();
    strands.push_back(bent);
    const Result r = load(make_data(strands), Format::data);
    expect_strands(r->groom, strands);
    // A right angle is none; a turn back by 135 degrees is one.
    assert_int_equal(r->report.kinks, 1);
    assert_int_equal(r->report.kinked_strands, 1);
    expect_error(text(r->report), {"1 kink above 90 degrees in 1 strand"});
}

void reads_files_by_content(void **)
{
    const Folder folder;
    expect_strands(read(folder.write("a.hair", make_tfx(sample(), true)))->groom, sample());
    expect_strands(read(folder.write("b", make_hair(sample(), 1)))->groom, sample());
    expect_strands(read(folder.write("c.data", make_data(sample())))->groom, sample());
    const std::string unknown = folder.write("d.abc", make_data(sample()));
    expect_error(read(unknown).error(), {unknown, "unknown", ".abc", ".data"});
    const std::string plain = folder.write("e.hair", make_data(sample()));
    expect_error(read(plain).error(), {plain, "offset 0", "HAIR"});
    const std::string empty = folder.write("f.data", {});
    expect_error(read(empty).error(), {empty, "offset 0"});
    expect_error(read(folder.path()).error(), {folder.path(), "regular file"});
    expect_error(read(folder.path() + "/missing.tfx").error(), {"missing.tfx", "not exist"});
}

void survives_mutations(void **)
{
    const std::pair<Format, Bytes> files[] = {{Format::tfx, make_tfx(sample(), true)},
                                              {Format::hair, make_hair(sample(), 1 | 4)},
                                              {Format::hair, make_hair(sample(), 8 | 16)},
                                              {Format::data, make_data(sample())}};
    std::uint32_t state = 20240229u;
    const auto random = [&](std::size_t below) {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        return std::size_t(state) % below;
    };
    std::size_t accepted = 0;
    for (int round = 0; round < 20000; ++round) {
        const auto &[format, whole] = files[random(4)];
        Bytes b = whole;
        for (std::size_t flips = 1 + random(4); flips > 0; --flips) {
            // Headers decide most, so half of the flips go there.
            const std::size_t at = random(random(2) ? 32 : b.size());
            b[at] = std::uint8_t(random(3) ? b[at] ^ (1u << random(8)) : random(256));
        }
        const Result r = load(b, format);
        if (r) {
            ++accepted;
            check_promises(r->groom);
            assert_true(r->groom.points.size() <= b.size() / 12);
            assert_false(text(r->report).empty());
        } else {
            assert_false(r.error().empty());
        }
    }
    assert_in_range(accepted, 2000, 18000);
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(reads_tfx),
        cmocka_unit_test(reads_hair),
        cmocka_unit_test(reads_data),
        cmocka_unit_test(refuses_every_truncation),
        cmocka_unit_test(refuses_lies_about_counts),
        cmocka_unit_test(refuses_lies_about_sections),
        cmocka_unit_test(drops_and_counts_bad_points),
        cmocka_unit_test(scales_and_turns),
        cmocka_unit_test(reports_kinks),
        cmocka_unit_test(reads_files_by_content),
        cmocka_unit_test(survives_mutations),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
