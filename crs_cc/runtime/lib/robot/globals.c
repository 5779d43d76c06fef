/* The variables through which a program and the client speak.

   Where the vendor's have no value at the start, ours have no initialiser, so that a program may
   define them itself, as some do (C17 6.9.2). */
#include <crs/robot.h>

long State[NUM_STATE];
int Smask[NUM_MASK];
int Laser[2 * NUM_LASER + 1];

char SERVER_MACHINE_NAME[80];
int SERV_TCP_PORT = 7019;

/* Called before main by programs that use the variable: Ndirect has another value. */
void __crs_start_SERV_TCP_PORT(void)
{
    if (__crs_is_direct())
        SERV_TCP_PORT = -1;
}

/* Nobody reads these. */
char ROBOT_MACHINE_NAME[80];
int CONN_TYPE = -1;
char SERIAL_PORT[40];
int SERIAL_BAUD = -1;
int ROBOT_TCP_PORT = -1;
double LASER_CALIBRATION[8];
double LASER_OFFSET[2];
