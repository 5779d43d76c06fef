/* How crs.h reaches its devices, for the library itself. */
#ifndef CRS_DEVICE_H
#define CRS_DEVICE_H

#include <crs.h>
#include <crs_request.h>

/* Posts a request with up to four numbers as its arguments and no data; returns its result. */
int __crs_ask_device(int code, struct __crs_message *message, int a, int b, int c, int d);

/* Posts a request that has been filled in; returns its result. */
int __crs_post_device(int code, struct __crs_message *message);

/* Copies numbers from a reply's data: `have` of them, at most `most`. Returns the number copied. */
int __crs_take_data(const struct __crs_message *message, int have, int *numbers, int most);

/* Reads the readings announced by a sensor's reply, page by page: `count` of them, at most
   `most`. Returns the number read. */
int __crs_take_readings(int sensor, int count, int *numbers, int most);

#endif
