"""Pictures and animations of bodies in space."""
