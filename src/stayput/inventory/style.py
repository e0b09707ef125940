"""The style in which QGIS draws the pieces: in the report's colours of the probability of overturning."""

from __future__ import annotations

from itertools import pairwise

from stayput.catalogue import say
from stayput.inventory.report import UNTOLD, colour
from stayput.report.palette import rgb

STYLE_NAME = "Probability of overturning"

CLASSES = (0.0, 0.05, 0.2, 0.5, 0.8, 1.0)
"""Probabilities between which a piece has one colour."""

_PAGE = """<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis version="3.28" styleCategories="Symbology">
 <renderer-v2 type="graduatedSymbol" attr="{attribute}" graduatedMethod="GraduatedColor" symbollevels="0" \
enableorderby="1" forceraster="0" referencescale="-1">
  <ranges>
{ranges}  </ranges>
  <symbols>
{symbols}  </symbols>
  <orderby>
   <orderByClause asc="1" nullsFirst="1">"overturned"</orderByClause>
  </orderby>
 </renderer-v2>
 <layerGeometryType>0</layerGeometryType>
</qgis>
"""

_ATTRIBUTE = "if(&quot;finding&quot; = 'too_few_runs', -1, &quot;overturned&quot;)"
"""What is coloured: −1 where the runs are too few to tell how safe a piece is."""

_RANGE = '   <range lower="{low}" upper="{high}" symbol="{number}" label="{label}" render="true"/>\n'

_SYMBOL = """   <symbol type="marker" name="{number}" alpha="1" clip_to_extent="1" force_rhr="0">
    <layer class="SimpleMarker" enabled="1" locked="0" pass="0">
     <Option type="Map">
      <Option type="QString" name="name" value="circle"/>
      <Option type="QString" name="color" value="{fill},255"/>
      <Option type="QString" name="outline_color" value="60,60,60,255"/>
      <Option type="QString" name="outline_width" value="0.2"/>
      <Option type="QString" name="size" value="2.6"/>
      <Option type="QString" name="size_unit" value="MM"/>
     </Option>
    </layer>
   </symbol>
"""


def style() -> str:
    """Return the style as QGIS keeps it (QML): pieces at greater risk are drawn above others."""
    ranges = "".join(
        _RANGE.format(low=low, high=high, number=n, label=f"{100 * low:g} - {100 * high:g} %")
        for n, (low, high) in enumerate(pairwise(CLASSES))
    ) + _RANGE.format(low=-1, high=-1, number=len(CLASSES) - 1, label=say("inventory_report.too_few_runs"))
    fills = [*(colour(0.5 * (low + high)) for low, high in pairwise(CLASSES)), UNTOLD]
    symbols = "".join(
        _SYMBOL.format(number=n, fill=",".join(map(str, rgb(fill)))) for n, fill in enumerate(fills)
    )
    return _PAGE.format(attribute=_ATTRIBUTE, ranges=ranges, symbols=symbols)
