/* Commands read from a script, dispatched by table, over a world of linked rooms. */
#include <stdio.h>
#include <string.h>

enum { NORTH, EAST, SOUTH, WEST, WAYS };
struct room { const char *name; struct room *way[WAYS]; const char *things[4]; };

static struct room hall, lab, store, dock;
static struct room hall = { "hall", { &lab, &store, NULL, &dock }, { "lamp" } };
static struct room lab = { "lab", { [SOUTH] = &hall }, { "robot", "wrench" } };
static struct room store = { .name = "store", .way[WEST] = &hall };
static struct room dock = { "dock", { [EAST] = &hall, [NORTH] = &lab }, { NULL } };

static struct room *at = &hall;
static const char *carried[4];
static int moves;

static const char **find(const char **list, const char *thing)
{
    for (int i = 0; i < 4; i++)
        if (thing ? list[i] && !strcmp(list[i], thing) : !list[i])
            return list + i;
    return NULL;
}

static void look(const char *unused)
{
    (void) unused;
    printf("  %s:", at->name);
    for (int i = 0; i < 4; i++)
        if (at->things[i])
            printf(" %s", at->things[i]);
    printf("\n");
}

static void go(const char *where)
{
    const char *p = strchr("nesw", where[0]);
    struct room *to = p && *where ? at->way[p - "nesw"] : NULL;
    (void) p;
    if (!to) {
        printf("  no way %s\n", where);
        return;
    }
    at = to;
    moves++;
    look("");
}

static void move(const char **from, const char **to, const char *thing)
{
    const char **place = find(from, thing), **room = find(to, NULL);
    if (place && room) {
        *room = *place;
        *place = NULL;
        printf("  ok\n");
    } else
        printf("  no %s\n", thing);
}

static void take(const char *thing) { move(at->things, carried, thing); }
static void drop(const char *thing) { move(carried, at->things, thing); }

static const struct { const char *verb; void (*act)(const char *); } commands[] = {
    { "look", look }, { "go", go }, { "take", take }, { "drop", drop },
};

int main(void)
{
    char script[] = "look;go north;take robot;take moon;go south;go south;go west;drop robot;"
                    "drop robot;go north;dance wildly;take wrench;look";

    for (char *line = strtok(script, ";"); line; line = strtok(NULL, ";")) {
        char verb[10] = "", object[10] = "";
        unsigned i;
        sscanf(line, "%9s %9s", verb, object);
        printf("> %s\n", line);
        for (i = 0; i < sizeof commands / sizeof *commands; i++)
            if (!strcmp(commands[i].verb, verb)) {
                commands[i].act(object);
                break;
            }
        if (i == sizeof commands / sizeof *commands)
            printf("  cannot %s\n", verb);
    }
    printf("%d moves, %s\n", moves, dock.things[0] ? dock.things[0] : "nothing");
    return 0;
}
