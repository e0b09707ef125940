"""What is known of the test, and what is not and has to be stated.

Tokyo Metropolitan Government, product test of devices against overturning, 2015: furniture on flooring on a
shaking table under JMA Kobe of 1995, three components, at 100 % and at 60 %. Seven devices were tested alone,
and a stopper together with a pole. What is used here is the published summary; the products, which piece each
device held, which way the pieces faced and how far the wall was are not part of it.
"""

from __future__ import annotations

from stayput.body import Body
from stayput.room import Ceiling, Floor, Room, Wall

BODIES = {"chest": Body(0.42, 1.365, 81.3), "cupboard": Body(0.40, 1.80, 100.4)}
"""The furniture of the test: a chest of drawers (tansu) and a cupboard; width is its depth."""

LEVELS = (1.0, 0.6)
"""Factors on the record."""

FLOORING = "wood flooring"
"""The floor, of which the friction is a default."""

ROOM = Room(Floor.of(FLOORING), left_wall=Wall(0.02), ceiling=Ceiling(2.4))
"""The room: distance to the wall and height of the ceiling are ours."""

FAR, SOME = 0.30, 0.10
"""Movements that the published result tells apart [m]."""
