"""The tiers whose cost is measured, out of demo/bench/tiers.inc, and their whole fragment shaders."""

import collections
import json
import pathlib
import re

import cost

HERE = pathlib.Path(__file__).resolve().parent
LIST = HERE.parent.parent / 'demo' / 'bench' / 'tiers.inc'
INPUTS = ('front', 'behind', 'direct', 'transmittance')
Tier = collections.namedtuple('Tier', 'name model fine fetches expression')


def read():
    """{name: Tier} in the file's order."""
    found = re.findall(r'^TIER\((\w+), (\w+), ([01]), (\d+),\s*((?:"[^"]*"\s*)+)\)', LIST.read_text('utf-8'),
                       re.M)
    return {name: Tier(name, model, fine == '1', int(fetches),
                       ''.join(re.findall(r'"([^"]*)"', text)))
            for name, model, fine, fetches, text in found}


TIERS = read()


def source(tsuya, tier, *options):
    """A fragment shader for Vulkan: the model's harness with the tier's expression in it.

    Options go to `tsuya glsl`."""
    words = [tsuya, 'glsl', tier.model, '--harness', '--target', 'vulkan', *options]
    text = cost.run(words + (['--variant', 'fine'] if tier.fine else []), tier.name)
    head, main = text.split('void main()')
    body = re.sub(r'(sum \+= ).*;', lambda match: f'{match[1]}{tier.expression};', main)
    if body == main and tier.expression not in main:
        raise cost.Failure(f'{tier.name}: the harness of {tier.model} has no line "sum += ...;".')
    slot = max(int(n) for n in re.findall(r'layout\(location = (\d+)\) (?:flat )?in ', head))
    for name in INPUTS:
        if re.search(rf'\b{name}\b', tier.expression) and not re.search(rf' in float {name};', head):
            slot += 1
            head += f'layout(location = {slot}) in float {name};\n'
    if 'numbers[' in tier.expression:
        head += 'layout(std140, set = 0, binding = 7) uniform host { mat3x4 numbers[6]; };\n'
    return f'{head}void main(){body}'


def map_sources(tsuya):
    """Fragment shaders that take from a deep opacity map of 8 layers all that multiple scattering
    asks for, the transmittance alone, and nothing: the differences are what a look costs."""
    text = cost.run([tsuya, 'glsl', 'deep_opacity', '--target', 'vulkan'], 'deep_opacity')
    head = ('#version 450\nlayout(location = 0) in vec3 position;\n'
            'layout(location = 0) out vec4 o;\n')
    maps = ''.join(f'layout(set = 0, binding = {i}) uniform sampler2D map{i};\n' for i in range(3))
    read = (f'{head}{maps}layout(std140, set = 0, binding = 3) uniform host {{ vec4 record[12]; }};\n'
            f'{text}void main()\n{{\n    tsu_hair_shadow s = tsu_deep_opacity_read8(map0, map1, map2, '
            'record, position);\n    o = ')
    return (f'{read}vec4(s.front, s.behind, s.direct, 1.0);\n}}\n',
            f'{read}vec4(position, s.transmittance);\n}}\n',
            f'{head}void main()\n{{\n    o = vec4(position, 1.0);\n}}\n')


def table_bytes(tsuya):
    """{tier: bytes of the tables of a material}."""
    models = json.loads(cost.run([tsuya, 'models', '--json'], 'the list of models'))['models']
    tables = {model['name']: model['tables'] for model in models}
    return {tier.name: sum(table['bytes'] for table in tables[tier.model] if not table['variant']
                           or f'_{table["variant"]}_eval(' in tier.expression)
            for tier in TIERS.values()}
