/* A function that is declared and called but nowhere defined. */
extern int nowhere(int n);

int main(void)
{
    return nowhere(3); // error: nowhere
}
