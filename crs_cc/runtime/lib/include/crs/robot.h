/* How the Nomadic client reaches its robot, for the library itself. */
#ifndef CRS_ROBOT_H
#define CRS_ROBOT_H

#include <Nclient.h>
#include <crs_request.h>

#define CRS_IPC_ERROR 111   /* State[STATE_ERROR] when nobody answers (vendor source Nclient.c) */
#define CRS_REFUSED 1       /* the same when a request was refused; chosen by us */

/* The state of a client. */
struct __crs_client {
    int connected;
    int left;                      /* quit_server has ended the server: nobody answers */
    int model;                     /* MODEL_N200, MODEL_N150 or MODEL_SCOUT */
    int mask[NUM_MASK];            /* the mask in use: Smask as ct sent it last */
    unsigned long board_ms;        /* time of the sensor board in the last reply that had it */
    unsigned char cpu_battery, motor_battery;   /* readings of 0 to 255 */
};

extern struct __crs_client __crs_client;

/* Two functions that the vendor's libraries have, but no header of his declares. */
int pa(int trans, int steer, int turret);
int conf_ser(unsigned char port, unsigned short baud);

/* Returns whether ours is to behave like Ndirect. */
int __crs_is_direct(void);

/* The same, and the robot is no Nomad 200, so that Ndirect knows less commands. */
int __crs_is_direct_without_sensors(void);

/* Posts a request whose reply is its result only; returns the result. Without a
   connection or a server it prints the client's message and returns 0. */
int __crs_post(int code, struct __crs_message *message);

/* Posts a request whose reply the vendor's client does not look at, and stores its result in
   *result if that is not NULL; returns FALSE without a connection only. Without a message nothing
   is posted. */
int __crs_tell(int code, struct __crs_message *message, int *result);

/* Returns whether somebody answers; prints the client's message without a connection. */
int __crs_is_reached(void);

/* Result of a command whose request failed: TRUE under Ndirect if the robot has answered. */
int __crs_was_refused(void);

/* Stores the time of the sensor board in a reply. */
void __crs_take_board_time(const struct __crs_message *message);

/* Posts a request whose reply is the whole state, and refreshes the elements that the mask
   selects; returns TRUE on success. */
int __crs_post_state(int code, struct __crs_message *message);

/* The same with up to four numbers as its arguments. */
int __crs_command(int code, int a, int b, int c, int d);

/* Posts a request for one group of State, State[first] to State[last], whatever the mask. */
int __crs_read_group(int code, int first, int last);

/* The same for a group whose reply has the time of the sensor board. */
int __crs_read_sensors(int code, int first, int last);

/* Reads `count` points or segments of the laser that lie ready, of a prediction or of the last
   reply, into an array as large as Laser. */
void __crs_read_laser(int *laser, int count, int predicted);

/* Sends Smask, which is in use from now on; FALSE where Ndirect does not know how. */
int __crs_use_mask(void);

/* The same with a mask that selects all but PosData. */
int __crs_use_initial_mask(void);

/* A number as it comes out of the serial line: sixteen bits, of which one is the sign. */
int __crs_wired(int value);

#endif
