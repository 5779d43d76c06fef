/* A name does not fit into its array. */
#include <stdio.h>
#include <string.h>

struct robot {
    int speed;
    char name[8];
};

static void set_up(struct robot *r, const char *name)
{
    r->speed = 100;
    strcpy(r->name, name); // error: out of bounds
}

int main(void)
{
    struct robot scout;

    set_up(&scout, "Nomad");
    set_up(&scout, "Nomadic Scout");
    printf("%s %d\n", scout.name, scout.speed);
    return 0;
}
