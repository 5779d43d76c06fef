/* A path is joined in an array that is too short, before another member. */
#include <stdio.h>
#include <string.h>
struct file { char name[12]; int size; };
static void set(struct file *f, const char *name)
{
    size_t i;
    for (i = 0; i <= strlen(name); i++)
        f->name[i] = name[i]; // error: out of bounds
}
int main(void)
{
    struct file f = {"", 7};
    set(&f, PLANT("corridor.map", "hall.map"));
    printf("%s\n", f.name);
    return 0;
}
