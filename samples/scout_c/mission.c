/*
 * mission.c - execute the commands of a text file.
 *
 *     forward INCHES      drive so far (negative: backwards)
 *     left DEGREES        turn in place; right DEGREES the other way
 *     speed INCHES        inches per second from now on, 1 to 20
 *     approach INCHES     drive until something ahead is so near
 *     look                say what is ahead, at the left, behind and at the right
 *     wait SECONDS
 *     say TEXT
 *     repeat N ... end    do what stands between N times; may be nested
 *     home INCHES         an error unless the start is so near
 *
 * Any error, such as an unknown word or a closed bumper, jumps to main() with longjmp()
 * from any depth. There the robot is stopped, and the line is printed.
 *
 * Usage:  crs run mission.c studio.xml --file samples/scout_c/mission.txt
 *         ... --file other.txt -- other.txt
 */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define MAX_LINES  200
#define MAX_TEXT   80

typedef struct {
    const char *word;
    void (*run)(double number, const char *text);
    enum { NOTHING, NUMBER, TEXT } wants;
} Command;

static char lines[MAX_LINES][MAX_TEXT];
static int n_lines, line_now;              /* the current line */
static jmp_buf trouble;                    /* where to continue after an error */
static char what[2 * MAX_TEXT];            /* the error message */
static int done;                           /* commands so far */

static int order[16] = { 0, 4, 12, 1, 15, 8, 255 };

static void fail(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    longjmp(trouble, 1);
}

/* ---- the commands ---- */

/* Waits for the end of a move; fails if it ends at an obstacle. */
static void finish(void)
{
    do {
        gs();
        if (State[STATE_BUMPER] != 0)
            fail("bumped at (%.1f, %.1f)", State[STATE_CONF_X] / 10.0,
                 State[STATE_CONF_Y] / 10.0);
        usleep(60000);
    } while (State[STATE_MOTOR_STATUS] & 3);
}

static void forward(double inches, const char *text)
{
    scout_pr((int) (10.0 * inches), 0);
    finish();
}

static void left(double degrees, const char *text)
{
    scout_pr(0, (int) (10.0 * degrees));
    finish();
}

static void right(double degrees, const char *text)
{
    left(-degrees, text);
}

static int top_speed = 100;                /* 0.1 inch/s */

static void speed(double inches, const char *text)
{
    if (inches < 1.0 || inches > 20.0)
        fail("a speed of %g is not between 1 and 20", inches);
    top_speed = (int) (10.0 * inches);
    sp(top_speed, top_speed, 0);
}

static long ahead(void)
{
    long nearest = State[STATE_SONAR_0];

    if (State[STATE_SONAR_1] < nearest)
        nearest = State[STATE_SONAR_1];
    if (State[STATE_SONAR_15] < nearest)
        nearest = State[STATE_SONAR_15];
    return nearest;
}

static void approach(double inches, const char *text)
{
    usleep(500000);                        /* readings from before the turn are outdated */
    gs();
    while (ahead() > inches) {
        int trans = ahead() > inches + 15.0 ? top_speed : 30;

        scout_vm(trans, 0);
        if (State[STATE_BUMPER] != 0)
            fail("bumped while %ld in were free", ahead());
        usleep(50000);
    }
    st();
    finish();
}

static void look(double number, const char *text)
{
    usleep(500000);
    get_sn();
    printf("      ahead %ld  left %ld  behind %ld  right %ld\n", State[STATE_SONAR_0],
           State[STATE_SONAR_4], State[STATE_SONAR_8], State[STATE_SONAR_12]);
}

static void pause_for(double seconds, const char *text)
{
    usleep((unsigned) (seconds * 1e6));
}

static void say(double number, const char *text)
{
    printf("      \"%s\"\n", text);
}

static void home(double inches, const char *text)
{
    double off = hypot(State[STATE_CONF_X], State[STATE_CONF_Y]) / 10.0;

    if (off > inches)
        fail("%.1f in from home", off);
    printf("      %.1f in from home\n", off);
}

static const Command commands[] = {
    { "forward", forward, NUMBER }, { "left", left, NUMBER },   { "right", right, NUMBER },
    { "speed", speed, NUMBER },     { "wait", pause_for, NUMBER }, { "say", say, TEXT },
    { "approach", approach, NUMBER }, { "look", look, NOTHING }, { "home", home, NUMBER },
};

/* ---- the language ---- */

/* Returns the first word of a line, and the rest of it. */
static char *split(int line, char *copy, char **rest)
{
    char *word;

    strcpy(copy, lines[line]);
    word = strtok(copy, " \t");
    *rest = strtok(NULL, "");
    return word;
}

static double number_in(const char *text)
{
    char *end;
    double value;

    if (text == NULL)
        fail("a number is missing");
    value = strtod(text, &end);
    if (end == text || end[strspn(end, " \t")] != '\0')
        fail("'%s' is not a number", text);
    return value;
}

static void run_command(const char *word, const char *rest)
{
    size_t i;

    for (i = 0; i < sizeof commands / sizeof *commands; i++)
        if (strcmp(word, commands[i].word) == 0) {
            double number = commands[i].wants == NUMBER ? number_in(rest) : 0.0;
            if (commands[i].wants == TEXT && rest == NULL)
                fail("'%s' what?", word);
            commands[i].run(number, rest);
            done++;
            printf("%4d  %-16s (%6.1f, %6.1f) heading %5.1f\n", line_now + 1, lines[line_now],
                   State[STATE_CONF_X] / 10.0, State[STATE_CONF_Y] / 10.0,
                   State[STATE_CONF_STEER] / 10.0);
            return;
        }
    fail("'%s' is no command", word);
}

/* Executes a line up to its matching "end"; returns the line after that. */
static int run_block(int line, int depth, int for_show)
{
    char copy[MAX_TEXT], *word, *rest;
    int behind, times;

    while (line < n_lines) {
        line_now = line;
        word = split(line, copy, &rest);
        if (word == NULL || *word == '#') {
            line++;
        } else if (strcmp(word, "end") == 0) {
            if (depth == 0)
                fail("'end' without 'repeat'");
            return line + 1;
        } else if (strcmp(word, "repeat") == 0) {
            times = (int) number_in(rest);
            behind = run_block(line + 1, depth + 1, TRUE);      /* find its end */
            while (!for_show && times-- > 0)
                run_block(line + 1, depth + 1, FALSE);
            line = behind;
        } else {
            if (!for_show)
                run_command(word, rest);
            line++;
        }
    }
    if (depth > 0)
        fail("'repeat' without 'end'");
    return line;
}

static void read_lines(const char *name)
{
    FILE *file = fopen(name, "r");
    char *start;

    if (file == NULL) {
        perror(name);
        exit(1);
    }
    while (n_lines < MAX_LINES && fgets(lines[n_lines], MAX_TEXT, file) != NULL) {
        start = lines[n_lines] + strspn(lines[n_lines], " \t");
        start[strcspn(start, "\n")] = '\0';
        memmove(lines[n_lines++], start, strlen(start) + 1);
    }
    fclose(file);
}

int main(int argc, char **argv)
{
    const char *name = argc > 1 ? argv[1] : "samples/scout_c/mission.txt";

    read_lines(name);
    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "mission: no robot\n");
        return 1;
    }
    conf_tm(5);
    conf_sn(15, order);
    ac(200, 200, 0);
    dp(0, 0);
    da(0, 0);
    if (setjmp(trouble) != 0) {
        st();
        printf("%s:%d: %s\n", name, line_now + 1, what);
        disconnect_robot(ROBOT_ID);
        return 1;
    }
    run_block(0, 0, FALSE);
    printf("%d commands done\n", done);
    disconnect_robot(ROBOT_ID);
    return 0;
}
