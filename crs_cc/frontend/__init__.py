"""The front end: C source to the typed intermediate representation, see `frontend.unit`."""
