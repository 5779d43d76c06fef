/* The head of a list is overwritten: nothing points to its nodes any more. */
#include <stdlib.h>
struct node { struct node *next; int n; };
int main(void)
{
    static struct node *head;
    head = malloc(sizeof *head); // leak: 2
    head->next = malloc(sizeof *head);
    head->next->next = NULL;
    PLANT(head = NULL, head->n = 0);
    return 0;
}
