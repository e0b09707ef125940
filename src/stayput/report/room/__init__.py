"""The verdict on a room as a report and as plain values."""
