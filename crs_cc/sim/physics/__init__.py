"""Contacts: what happens when robots and things get in each other's way; alone knows pymunk."""
