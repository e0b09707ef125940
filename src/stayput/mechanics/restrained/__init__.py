"""A body held by devices: the second kernel, for cases that have force elements."""
