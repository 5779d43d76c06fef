/* A flexible array member at the end of a struct (C17 6.7.2.1p18). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct packet { unsigned char type; unsigned short length; char data[]; };

static struct packet *make(int type, const char *text)
{
    struct packet *p = malloc(sizeof(struct packet) + strlen(text) + 1);

    p->type = type;
    p->length = strlen(text);
    strcpy(p->data, text);
    return p;
}

int main(void)
{
    struct packet *list[3] = { make(1, "vm 100 100"), make(2, ""), make(200, "sonar") };
    int i, total = 0;

    for (i = 0; i < 3; i++) {
        printf("%d %d [%s]\n", list[i]->type, list[i]->length, list[i]->data);
        total += sizeof *list[i] + list[i]->length;
        free(list[i]);
    }
    printf("%d %d\n", total, (int) sizeof(struct packet));
    return 0;
}
