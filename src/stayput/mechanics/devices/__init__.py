"""The solver for bodies with devices: force elements beside the contacts, Dormand–Prince integration."""
