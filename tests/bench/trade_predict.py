"""The chooser's predictor, once more and in Python: what trade.py fits and the tests compare.

Plain Python, no packages. A fit is {term: coefficient}; a scene is a dict of its traits with the
names of the table's ranges, sigma_a one number (a channel's).
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'runtime' / 'choose'))
import embed  # noqa: E402  (tiers, terms and ranges have one list)

HAIR, LEAF, TERMS, RANGES = embed.HAIR, embed.LEAF, embed.TERMS, embed.RANGES
GPUS, TONES, COLORS = embed.GPUS, embed.TONES, embed.COLORS
REC709 = (0.2126, 0.7152, 0.0722)


def held(scene, ranges):
    """The scene with every trait within its range, and the names of those that were not."""
    inside = {n: min(max(scene[n], ranges[n][0]), ranges[n][1]) for n in RANGES}
    return inside, [n for n in RANGES if inside[n] != scene[n]]


def terms(scene):
    """All terms of a channel, in order."""
    root = math.sqrt(scene['sigma_a'])
    trait = {'u': root / (root + math.sqrt(0.1)), 'q': math.sqrt(scene['sky_share']),
             'k': scene['light_cosine'], 'w': math.log2(scene['strand_pixels']),
             'd': math.log2(1.0 + scene['depth']), 'o': scene['curl'],
             'b': scene['beta_R'] / math.radians(7.5)}
    return [math.prod(trait[name] for name in term.split('*') if name != '1') for term in TERMS]


def weight(channel, sigma_a):
    """Of a channel in the luminance of a head."""
    return REC709[channel] * math.exp(-5.9 * math.sqrt(sigma_a))


def dot(coefficients, values):
    return sum(c * v for c, v in zip(coefficients, values))


def predict(fit_rms, fit_luminance, channels):
    """(rms, luminance error) of a scene of three channels (scenes within the ranges)."""
    rows = [terms(scene) for scene in channels]
    square = sum(math.exp(dot(fit_rms, row)) for row in rows) / 3.0
    weights = [weight(c, scene['sigma_a']) for c, scene in enumerate(channels)]
    gain = sum(w * math.exp(dot(fit_luminance, row)) for w, row in zip(weights, rows))
    return math.sqrt(square), gain / sum(weights) - 1.0
