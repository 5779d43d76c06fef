/* Names and addresses of computers, names of services, for the library itself. */
#ifndef CRS_NAMES_H
#define CRS_NAMES_H

#include <netinet/in.h>

/* Reads an internet address; returns 0 if the text is none. */
int __crs_read_address(const char *text, int only_decimal, unsigned int *address);

/* Writes an internet address, and returns the text. */
char *__crs_write_address(unsigned int address, char *text);

/* Looks up the address of a name; returns 0 if there is none. */
int __crs_look_up(const char *name, struct in_addr *address);

/* Stores the name of an address, at most 249 bytes; returns its length, 0 if there is none. */
int __crs_name_of(struct in_addr address, char *name);

/* Returns the port of a service, -1 if there is none of this name. */
int __crs_port_of(const char *service);

/* Returns the service of a port, null if there is none. */
const char *__crs_service_at(int port);

#endif
