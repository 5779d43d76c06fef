/* Names of computers, for the library itself. */
#ifndef CRS_NAMES_H
#define CRS_NAMES_H

#include <netinet/in.h>

/* Looks up the address of a name; returns 0 if there is none. */
int __crs_look_up(const char *name, struct in_addr *address);

/* Stores the name of an address, at most 249 bytes; returns its length, 0 if there is none. */
int __crs_name_of(struct in_addr address, char *name);

#endif
