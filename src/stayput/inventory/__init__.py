"""Inventories: every piece of a building, a company or a city, assessed in one go."""

from __future__ import annotations

from stayput.inventory.assess import Assessment, assess

__all__ = ["Assessment", "assess"]
