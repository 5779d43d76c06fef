/* The firing order of sensors, for the library itself. */
#ifndef CRS_ORDER_H
#define CRS_ORDER_H

#include <crs_request.h>

/* Puts an order into a request's data. It ends with 255 or after sixteen sensors; a null pointer
   is an order without any, so that none measures. */
void __crs_put_order(struct __crs_message *message, const int *order);

#endif
