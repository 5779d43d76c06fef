/* What robots have here beyond the vendor's: devices, and messages from robot to robot.

   It goes with Nclient.h, and with the report's dialect. Lengths are in 0.1 inch, angles in 0.1
   degree, counter-clockwise. A function gives TRUE (1), or FALSE (0) when the robot has no such
   device, unless said otherwise. No connection is needed. docs/crs-h.md has it all. */
#ifndef _CRS_H
#define _CRS_H

/* GPS receiver, inclinometer, and other sensors that read a few numbers. */
#include <crs/registered.h>

/* A column of a camera's picture: what colour it shows, 0xRRGGBB, and how far away that is: 0.1
   inch, -1 where nothing is in range. */
struct crs_pixel {
    int colour;
    int range;
};

/* Neighbouring columns of one colour: where their middle is, from where the camera looks, to the
   left counting above 0; how wide they are, both 0.1 degree; their colour; the range of the
   nearest. */
struct crs_blob {
    int angle;
    int width;
    int colour;
    int range;
};

/* Lets the camera look. Both tell from the left to the right, as many as there is room for, and
   give how many these are. */
int crs_camera(struct crs_pixel *row, int most);
int crs_blobs(struct crs_blob *blobs, int most);

/* How much heat there is around. */
int crs_heat(int *heat);

/* Lets the laser look; tells how far away things are in each direction, from the right to the left:
   0.1 inch, -1 where nothing is in range. Gives how many it told, at most `most`; 0 also while the
   laser is switched off, as by conf_ls(). */
int crs_laser(int *ranges, int most);

/* Sensors that may measure by a timer of their own. */
#define CRS_SENSOR_CAMERA 1
#define CRS_SENSOR_HEAT 2
#define CRS_SENSOR_LASER 3
#define CRS_SENSOR_INFRARED 4
#define CRS_SENSOR_COMPASS 5

/* Sets how often a sensor measures by itself, the first time now; whoever asks for its reading is
   then told the last one. 0: it measures when it is asked. Its rate is the shortest period there
   is. */
int crs_period(int sensor, int ms);

/* How long ago a sensor measured what it tells: ms, -1 for never, and without such a sensor. */
int crs_age(int sensor);

/* The gripper opens or closes, in its own time; the function returns at once. It closes on what is
   between its fingers and carries it until it opens. */
#define CRS_OPEN 0
#define CRS_CLOSE 1
int crs_gripper(int what);

/* How far the fingers are apart (0.1 inch), whether anything breaks the beam between them, and what
   they hold weighs (gram, 0 for nothing). Any of the pointers may be NULL. */
int crs_get_gripper(int *opening, int *beam, int *weight);

/* The joints of the arm turn to angles, or on by angles from where they are, in their own time; the
   functions return at once. 0 is straight on. 0.1 degree. */
int crs_arm_move(int shoulder, int elbow);
int crs_arm_turn(int shoulder, int elbow);

/* Where the joints are (0.1 degree), and the tip: ahead of the robot's middle and to the left (0.1
   inch). Any of the pointers may be NULL. */
int crs_arm_get(int *shoulder, int *elbow, int *x, int *y);

/* The hand at the tip closes on what is there and lifts it, or opens as soon as there is room
   below; the function returns at once. What it holds weighs this (gram, 0 for nothing). */
int crs_hand(int what);
int crs_get_hand(int *weight);

/* Takes the heat from all things near; gives how many lost theirs. */
int crs_tag(void);

/* Messages go from robot to robot on a channel: these, and what the world has besides. Robots count
   from 0. */
#define CRS_RADIO    0
#define CRS_INFRARED 1
#define CRS_LOCAL    2

#define CRS_ALL          (-1)
#define CRS_MESSAGE_SIZE 248     /* most bytes of a message */
#define CRS_FOREVER      (-1)

/* A message that came in. */
struct crs_message {
    int from;                    /* the sender's number */
    int to;                      /* one's own number, or CRS_ALL */
    int group;                   /* the group it was sent to, -1 for none */
    int type;                    /* what the sender said */
    int channel;
    int sent;                    /* when, in ms since the start of the run */
    int arrived;
    int size;                    /* bytes of data */
    char data[CRS_MESSAGE_SIZE + 1];   /* behind the last byte stands a 0 */
};

/* FALSE also for what is too large, or dropped because too many wait; TRUE does not say that a
   message arrives. */
int crs_send(int to, int type, const void *data, int size);
int crs_broadcast(int type, const void *data, int size);
int crs_multicast(int group, int type, const void *data, int size);

/* Where later messages are sent, at first CRS_RADIO. */
int crs_use_channel(int channel);

/* Takes the oldest message that has arrived. If there is none, waits so long for one, 0 not at all;
   FALSE for none. */
int crs_receive(struct crs_message *message, int milliseconds);
int crs_message_count(void);

/* Groups are 0 to 31. */
int crs_join_group(int group);
int crs_leave_group(int group);

/* Numbers and names; -1 for none of that name. A name that has no room is cut off. */
int crs_find_channel(const char *name);
int crs_my_number(void);
int crs_robot_count(void);
int crs_find_robot(const char *name);
int crs_robot_name(int number, char *name, int size);

#endif
