/* A variable that is declared extern but nowhere defined. */
extern int nowhere;

int main(void)
{
    return nowhere; // error: nowhere
}
