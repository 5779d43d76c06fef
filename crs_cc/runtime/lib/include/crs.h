/* Devices and communication between robots, in addition to the vendor's Nclient.h.

   The header can be used with Nclient.h and with the report's dialect. Lengths are in units of
   0.1 inch, angles in units of 0.1 degree, counter-clockwise. Unless stated otherwise, functions
   return TRUE (1), or FALSE (0) if the robot lacks the device. Programs need not call
   connect_robot() first. Reference: docs/crs-h.md. */
#ifndef _CRS_H
#define _CRS_H

/* Devices, and the numbers CRS_SENSOR_... of those that can measure periodically. */
#include <crs/registered.h>

/* Set the period at which a sensor measures, starting now; functions that read it then return the
   last measurement. With a period of 0 it measures on request. The period is limited by the rate
   of the sensor. */
int crs_period(int sensor, int ms);

/* Return the age of a sensor's last measurement in ms; -1 if there is none, or if there is no such
   sensor. */
int crs_age(int sensor);

/* Communication channels; a world file can define more. Robots are numbered from 0. */
#define CRS_RADIO    0
#define CRS_INFRARED 1
#define CRS_LOCAL    2

#define CRS_ALL          (-1)
#define CRS_MESSAGE_SIZE 248     /* maximum size of a message in bytes */
#define CRS_FOREVER      (-1)

/* A received message. */
struct crs_message {
    int from;                    /* the sender's number */
    int to;                      /* the receiver's number, or CRS_ALL */
    int group;                   /* the group that it was sent to, -1 for none */
    int type;                    /* as given by the sender */
    int channel;
    int sent;                    /* time in ms since the start of the run */
    int arrived;
    int size;                    /* size of data in bytes */
    char data[CRS_MESSAGE_SIZE + 1];   /* followed by a null character */
};

/* Send a message. FALSE if it is too large, or dropped because the queue is full; TRUE does not
   guarantee delivery. */
int crs_send(int to, int type, const void *data, int size);
int crs_broadcast(int type, const void *data, int size);
int crs_multicast(int group, int type, const void *data, int size);

/* Select the channel for subsequent messages, initially CRS_RADIO. */
int crs_use_channel(int channel);

/* Receive the oldest message in the inbox. If it is empty, wait for at most this time, 0 to return
   immediately; FALSE if there is no message. */
int crs_receive(struct crs_message *message, int milliseconds);
int crs_message_count(void);

/* Join or leave a group, 0 to 31. */
int crs_join_group(int group);
int crs_leave_group(int group);

/* Numbers and names; -1 if the name is unknown. A name that does not fit is truncated. */
int crs_find_channel(const char *name);
int crs_find_field(const char *name);
int crs_my_number(void);
int crs_robot_count(void);
int crs_find_robot(const char *name);
int crs_robot_name(int number, char *name, int size);

#endif
