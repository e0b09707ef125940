"""Rigid bodies in space: nonsmooth time stepping, compiled."""
