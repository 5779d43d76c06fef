/* Connecting to the robot. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <crs/robot.h>

#define OWN_MACHINE "robot"   /* the result of gethostname */
#define DEFAULT_BAUD 38400
#define DEFAULT_PORT 65001    /* at which a robot listens */

static void greet(const char *name)
{
    static int greeted;

    if (!greeted)
        fprintf(stderr, "%s version 2.7\nCopyright 1991-1998, Nomadic Technologies, Inc.\n", name);
    greeted = 1;
}

/* The server's reply to a successful connection: a port of its own, neither 0 nor 1. */
static int port(void)
{
    return SERV_TCP_PORT > 1 ? SERV_TCP_PORT : 7019;
}

static void report_no_server(void)
{
    printf("failed to connect to server on machine %s via tcp port #%d \n",
           SERVER_MACHINE_NAME[0] != 0 ? SERVER_MACHINE_NAME : OWN_MACHINE, SERV_TCP_PORT);
}

/* Requests a robot; returns whether it is connected. On failure nothing changes. */
static int ask_for_robot(int code, long id, int baud)
{
    struct __crs_message message;
    int before = __crs_client.connected;

    message.i[0] = id;
    message.i[1] = baud;
    message.size = 0;
    __crs_client.connected = 1;   /* the server listens to this even without a robot */
    if (!__crs_post(code, &message)) {
        __crs_client.connected = before;
        return FALSE;
    }
    __crs_client.model = message.i[0];
    return TRUE;
}

static int connect_to_server(long id)
{
    greet("Nclient");
    if (ask_for_robot(CRS_CONNECT, id, 0)) {
        __crs_use_initial_mask();
        return port();
    }
    if (__crs_client.left) {
        __crs_client.connected = 0;
        report_no_server();
    }
    return FALSE;
}

/* The mask that Ndirect keeps for robots that do not know `ct`. */
static void fix_mask(void)
{
    int i;

    for (i = 0; i < NUM_MASK; i++)
        __crs_client.mask[i] = i >= SMASK_SONAR_1 && i != SMASK_LASER;
}

static int is_serial(const char *device)
{
    size_t length = strlen(device);

    return strncmp(device, "/dev", 4) == 0 || (length > 0 && device[length - 1] == ':');
}

static int checked_baud(int baud)
{
    baud &= 0xFFFF;
    if (baud == 4800 || baud == 9600 || baud == 19200 || baud == 38400)
        return baud;
    if (baud != 0)
        fprintf(stderr, "Invalid baud rate %d, using %d\n", baud, DEFAULT_BAUD);
    return DEFAULT_BAUD;
}

static int connect_directly(long id, const char *device, int value)
{
    int serial = is_serial(device);
    int baud = serial ? checked_baud(value) : 0;

    if (!ask_for_robot(CRS_CONNECT, id, baud))
        return FALSE;
    if (serial)
        printf("Robot <-> Host serial communication setup\n(%d baud using %s)\n", baud, device);
    else
        printf("Robot <-> Host TCP/IP communication setup\n(machine %s on port %d)\n",
               device[0] != 0 ? device : "localhost", value != 0 ? value : DEFAULT_PORT);
    if (__crs_client.model == MODEL_N200)
        __crs_use_initial_mask();
    else
        fix_mask();
    return TRUE;
}

/* Nclient wants the robot's number alone; Ndirect the model, the device and its speed or port as
   well, which it reads without asking whether they are there. */
int connect_robot(long id, ...)
{
    va_list more;
    const char *device;
    int value;

    if (!__crs_is_direct())
        return connect_to_server(id);
    greet("Ndirect");
    va_start(more, id);
    (void)va_arg(more, int);   /* the model, which the robot reports as well */
    device = va_arg(more, char *);
    value = va_arg(more, int);
    va_end(more);
    return connect_directly(id, device, value);
}

int server_is_running(void)
{
    if (!__crs_is_direct())
        return connect_to_server(1);
    greet("Ndirect");
    return connect_directly(1, "/dev/ttyS0", DEFAULT_BAUD);
}

int create_robot(long id)
{
    if (__crs_is_direct())
        return TRUE;
    return ask_for_robot(CRS_CREATE, id, 0) ? port() : FALSE;
}

/* Under Ndirect nothing is sent, and the line stays open. */
int disconnect_robot(long id)
{
    struct __crs_message message;
    int result;

    if (__crs_is_direct())
        return TRUE;
    message.i[0] = id;
    message.size = 0;
    result = __crs_post(CRS_DISCONNECT, &message) != 0;
    __crs_client.connected = 0;
    return result;
}

static int ask_server(int code)
{
    struct __crs_message message;

    if (__crs_is_direct())
        return TRUE;
    message.size = 0;
    return __crs_tell(code, &message, NULL);
}

int quit_server(void)
{
    int result = ask_server(CRS_QUIT_SERVER);

    if (result && !__crs_is_direct())
        __crs_client.left = 1;
    return result;
}

int real_robot(void)
{
    return ask_server(CRS_REAL_ROBOT);
}

int simulated_robot(void)
{
    return ask_server(CRS_SIMULATED_ROBOT);
}

int set_server_machine_name(char *name)
{
    strcpy(SERVER_MACHINE_NAME, name);
    return TRUE;
}

int set_serv_tcp_port(int number)
{
    SERV_TCP_PORT = number;
    return TRUE;
}
