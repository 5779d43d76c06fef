/* Structs in structs in arrays in structs, five levels down. */
#include <stdio.h>

struct pose { short x, y; };
struct leg { struct pose at[2]; char used; };
struct plan { struct leg legs[3]; int count; };
struct robot { char name[4]; struct plan plans[2]; struct plan *current; };
struct team { struct robot members[2]; };

static struct team team;

static void walk(struct robot *r)
{
    struct leg *leg;

    for (leg = r->current->legs; leg < r->current->legs + r->current->count; leg++)
        printf("%s (%d,%d)-(%d,%d)%c ", r->name, leg->at[0].x, leg->at[0].y, leg->at[1].x,
               leg->at[1].y, leg->used ? '*' : ' ');
    printf("\n");
}

int main(void)
{
    int i, j, k;

    for (i = 0; i < 2; i++) {
        struct robot *r = &team.members[i];
        r->name[0] = 'R';
        r->name[1] = '0' + i;
        for (j = 0; j < 2; j++) {
            struct plan *p = r->plans + j;
            for (k = 0; k <= j + i; k++) {
                p->legs[k].at[0].x = 100 * i + 10 * j + k;
                p->legs[k].at[1] = p->legs[k].at[0];
                p->legs[k].at[1].y--;
                p->count++;
            }
        }
        r->current = &r->plans[1];
    }
    team.members[1].current->legs[1].used = 1;
    walk(&team.members[0]);
    walk(team.members + 1);
    team.members[0].plans[0] = *team.members[1].current;
    team.members[0].current = team.members[0].plans;
    walk(team.members);
    printf("%d\n", team.members[0].plans[0].legs[2].at[1].y);
    return 0;
}
