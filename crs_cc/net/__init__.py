"""Programs, viewers and clients on other machines."""
