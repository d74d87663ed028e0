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


def table_bytes(tsuya):
    """{model: bytes of the tables of a material}."""
    models = json.loads(cost.run([tsuya, 'models', '--json'], 'the list of models'))['models']
    return {model['name']: sum(table['bytes'] for table in model['tables']) for model in models}
