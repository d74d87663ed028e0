"""Cases of command_test.py: leaves and trees as pictures, meshes from files."""

import pathlib
import struct
import tempfile

from command_support import case, expect, output, refused

SQUARE = ('v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n'
          'f 1/1 2/2 3/3 4/4\n')


def number(said, name):
    return float(said.split(name)[1].split()[0].rstrip(','))


@case
def leaves_and_trees_are_drawn():
    with tempfile.TemporaryDirectory() as folder:
        picture = folder + '/t.png'
        said = output('render', 'leaf', 'leaf.texels=128', '--size', '40x60', '-o', picture)
        expect('leaf luminance' in said and number(said, 'leaf coverage') > 0.1, said)
        width, height = struct.unpack('>II', pathlib.Path(picture).read_bytes()[16:24])
        expect((width, height) == (40, 60), f'{width}x{height}')
        said = output('render', 'tree', 'leaves=321', 'supersample=1', '--size', '40x40',
                      '--frames', '2', '-o', picture)
        expect('leaves           321' in said and 'wood' in said, said)
        expect(pathlib.Path(folder, 't_0002.png').exists(), 'no second picture')


@case
def meshes_are_leaves():
    with tempfile.TemporaryDirectory() as folder:
        mesh = pathlib.Path(folder, 'square.obj')
        mesh.write_text(SQUARE)
        scene = pathlib.Path(folder, 'mine.scene')
        scene.write_text('kind=leaf\nmodel=leaf_body\nmesh=square.obj\nlight=back\ndome=0\n')
        for word in (str(mesh), str(scene)):
            said = output('render', word, '--size', '32x32', '-o', folder + '/t.exr')
            expect('triangles        2' in said, said)
            expect(number(said, 'leaf luminance') > 0.0, said)
        mesh.write_text(SQUARE.replace('v 1 1 0', 'v 1 nan 0'))
        refused(['render', str(mesh), '-o', folder + '/t.png'], None, 'square.obj', 'line 3', 'nan')
        refused(['render', str(scene), '-o', folder + '/t.png'], None, 'square.obj', 'line 3')


@case
def what_is_no_leaf_is_refused():
    with tempfile.TemporaryDirectory() as folder:
        picture = folder + '/t.png'
        refused(['render', 'leaf', 'model=marschner', '-o', picture], None, 'marschner', 'model=leaf')
        refused(['render', 'straight-brown', 'strands=100', 'model=leaf', '-o', picture], None,
                'leaf', 'pigment')
        refused(['render', 'leaf', 'leaf=grass', 'scatter_top=1,1,1', '-o', picture], None,
                'scatter_top', 'contents')
        refused(['render', 'leaf', 'leaf=gras', '-o', picture], None, 'leaf', 'grass')
        refused(['render', 'leaf', 'leaf.width=9', '-o', picture], None, 'leaf.width', '[0.05, 1.5]')
        refused(['render', 'tree', 'leaves=9', '-o', picture], None, 'leaves', '[200, 20000]')
        refused(['render', 'tree', 'mesh=a.obj', '-o', picture], None, 'mesh', 'kind=leaf')
    said = output('scenes', '--help')
    for key in ('kind=hair, leaf, tree', 'mesh=', 'mesh.pigment_map=none or PATH',
                'mesh.height_mm=[0, 1000], default 1', 'leaf=young_green', 'chlorophyll=', 'leaf.shape=beech', 'leaf.veins', 'leaves=',
                'tree.roundness'):
        expect(key in said, key)
    said = output('scenes', 'tree', 'leaf.fold_deg=12')
    for line in ('kind=tree', 'leaf.fold_deg=12', 'model=leaf'):
        expect(line in said.splitlines(), said)
